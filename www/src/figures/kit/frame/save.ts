/** A figure, or the picture of a lesson, as a file: what stands in it, without what moves it, in colours for paper. */
import { dark, setTheme, theme } from "#document/preferences";
import { WHITE } from "#style/colours";
import { type Drawing, drawingOfPage } from "#ui/drawing/page";
import { download, plainName, pngOf } from "#ui/files/download";
import control from "./control.module.css";
import frame from "./frame.module.css";
import layout from "./layout.module.css";

export interface Saved {
  kind: "png" | "svg";
  /** White behind it, or nothing. */
  ground: "white" | "clear";
}

export interface Named {
  number: string;
  title: string;
}

/** What only helps a hand. */
const WITHOUT = [
  `.${control["control"]}`,
  ...["controls", "buttons", "choice"].map((name) => `.${layout[name]}`),
  // The name of nothing else.
  `:is(h2, h3):has(+ .${layout["buttons"]}:not([role=group]))`,
].join(", ");

export async function saveFigure(page: Element, named: Named, { kind, ground }: Saved): Promise<void> {
  const drawing = await inLight(page, () => drawn(page, named, ground));
  const blob = new Blob([drawing.text], { type: "image/svg+xml" });
  const name = `frond-${plainName(named.number, "figure")}.${kind}`;
  download(kind === "svg" ? blob : await raster(drawing, blob), name);
}

function drawn(page: Element, { number, title }: Named, ground: Saved["ground"]): Drawing {
  // The question of a lesson is no part of its picture.
  const live = page.querySelector(`.${frame["figure-live"]}`);
  return drawingOfPage({
    parts: live ? [live] : [],
    title: `${number}: ${title}`,
    about: parametersOf(page),
    ground: ground === "white" ? WHITE : null,
    without: WITHOUT,
  });
}

/** The sliders are not in the file, so it says where they stood. */
function parametersOf(page: Element): string {
  return [...page.querySelectorAll(`.${frame["parameters"]} > div`)]
    .map((row) => [...row.children].map((part) => part.textContent?.trim() ?? "").join(": "))
    .join("; ")
    .replace(/(?<=[^.])$/, ".");
}

/** Pixels of the file for each of the page, where browsers let a canvas be so large. */
const FINE = 2;
const MOST_PIXELS = 16_000_000;

async function raster({ width, height }: Drawing, blob: Blob): Promise<Blob> {
  const scale = Math.min(FINE, Math.sqrt(MOST_PIXELS / (width * height)));
  const url = URL.createObjectURL(blob);
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = Math.floor(width * scale);
    canvas.height = Math.floor(height * scale);
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await pngOf(canvas);
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** Has the page light for as long as it is looked at. */
async function inLight<T>(page: Element, look: () => T): Promise<T> {
  if (!dark.peek()) return look();
  const before = theme.peek();
  setTheme("light", { keep: false });
  try {
    await settled(page);
    return look();
  } finally {
    setTheme(before, { keep: false });
  }
}

const LOOK_EVERY = 150;
const SAME = 4;
const MOST_LOOKS = 30;

/** Until the pictures are drawn anew; what moves all the time is not waited for. */
async function settled(page: Element): Promise<void> {
  let [seen, same] = ["", 0];
  for (let i = 0; i < MOST_LOOKS && same < SAME; i++) {
    await new Promise((resolve) => setTimeout(resolve, LOOK_EVERY));
    const now = [...page.querySelectorAll("canvas")].map(glance).join(" ");
    same = now === seen ? same + 1 : 0;
    seen = now;
  }
}

const pen = document.createElement("canvas").getContext("2d", { willReadFrequently: true });

/** A few pixels of a picture. */
function glance(picture: HTMLCanvasElement): string {
  if (!pen || picture.width * picture.height === 0) return "";
  pen.clearRect(0, 0, 16, 16);
  pen.drawImage(picture, 0, 0, 16, 16);
  return pen.getImageData(0, 0, 16, 16).data.join();
}
