/** A lesson on paper: nothing is guessed and nothing told, and what a teacher wants to know is on a page of its own. */
import { batch, signal } from "@preact/signals";
import { atOnce, beAsBefore, beLight } from "../../../kit/frame/print";
import { seenAtFirst } from "../../../kit/state/kept";

const on = signal(false);

/** Which pages: those that pupils get, the one for whoever teaches, or all. */
export type Part = "copies" | "answers" | "all";

/** What was chosen, while it is printed. */
let chosen: Part | null = null;

/** Whether the lesson is on its way to paper, where guesses and answers are covered. */
export const paper = on;

/** Whether pictures have the time to follow: the browser's own print takes them as they stand. */
export const inTime = signal(false);

/** The paper that there is, whatever its size: lessons are no pictures that have to keep their place. */
const PAGE = "@media print { @page { size: auto; margin: 14mm } }";

/** So long, in milliseconds, pictures take at most that are drawn anew because guesses are covered. */
const DRAWN_MS = 1500;
const LOOK_MS = 100;

/** From now on, until what it gives is called, this page is printed as a handout. */
export function printHandouts(): () => void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(PAGE);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  const begin = () => atOnce(() => set(true));
  const end = () => atOnce(() => set(false));
  addEventListener("beforeprint", begin);
  addEventListener("afterprint", end);
  return () => {
    set(false);
    removeEventListener("beforeprint", begin);
    removeEventListener("afterprint", end);
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((one) => one !== sheet);
  };
}

function set(is: boolean): void {
  const { dataset } = document.documentElement;
  // Before the page of the answers is opened for paper.
  // Where nothing was chosen, by the browser's own print, it is what pupils get: nobody prints answers unasked.
  if (is) dataset["handout"] ??= chosen ?? "copies";
  else delete dataset["handout"];
  batch(() => {
    on.value = is;
    inTime.value = is && chosen !== null;
    // A handout has exercises as they begin, and not what somebody made of them on the page.
    seenAtFirst.value = inTime.value ? /^x\d/ : null;
  });
}

const drawn = () => document.querySelectorAll("article canvas[data-complete]").length;

/** Prints, once the pictures are as they are to be. */
export async function printHandout(part: Part): Promise<void> {
  const before = drawn();
  chosen = part;
  // Before it is waited for pictures, which are drawn anew for light paper.
  beLight();
  set(true);
  for (let waited = 0; waited < DRAWN_MS; waited += LOOK_MS) {
    await new Promise((done) => setTimeout(done, LOOK_MS));
    if (waited > 2 * LOOK_MS && drawn() >= before) break;
  }
  print();
  chosen = null;
  set(false);
  beAsBefore();
}
