/** What all elements of a page share: the module, which is fetched once, and the workers that draw. */
import init, { LinkedMorph } from "../../pkg/frond-morph.js";
import { Pool } from "./pool";
import type { Decided, Drawing, Question } from "./protocol";
import { errorOf } from "./trouble";
import { unpacked } from "./unpack";

/** The module, packed into the script by the build. */
declare const FROND_MORPH: string;

/** Where nobody has asked for anything for so long, the workers go. */
const IDLE_MS = 10_000;

let starting: Promise<WebAssembly.Module> | null = null;
let pool: Pool | null = null;
let users = 0;
let leaving: ReturnType<typeof setTimeout> | undefined;

/** Once it is ready for this thread, too. */
function started(): Promise<WebAssembly.Module> {
  starting ??= begun();
  // What failed may go better the next time.
  starting.catch(() => {
    starting = null;
  });
  return starting;
}

async function begun(): Promise<WebAssembly.Module> {
  const module = await WebAssembly.compile(await unpacked(FROND_MORPH));
  await init({ module_or_path: module });
  return module;
}

/** The morph of a link. Free it. */
export async function morphOf(fragment: string): Promise<LinkedMorph> {
  await started();
  return new LinkedMorph(fragment);
}

async function pooled(): Promise<Pool> {
  const compiled = await started();
  pool ??= new Pool(compiled);
  return pool;
}

/** A picture; the `first` one of an element comes before all else. */
export async function draw(drawing: Drawing, first: boolean): Promise<Uint8ClampedArray<ArrayBuffer>> {
  return (await pooled()).draw(drawing, first);
}

/** Answers that are kept, and those that are on their way. */
const MOST_ANSWERS = 200;
const answers = new Map<string, { decided: Promise<Decided>; askers: Set<() => boolean> }>();

/**
 * What is asked more than once is decided once. `wanted` says whether an answer is still waited for: where nobody
 * does so when its turn comes, it is rejected as `cancelled`.
 */
export async function ask(question: Question, wanted: () => boolean): Promise<Decided> {
  const { proof: _, ...asked } = question;
  const key = JSON.stringify(asked);
  let answer = answers.get(key);
  if (answer) {
    answer.askers.add(wanted);
    // The oldest one in the list is the one that was asked for the longest ago.
    answers.delete(key);
  } else {
    const askers = new Set([wanted]);
    const decided = pooled().then((hands) => hands.ask(question, () => [...askers].some((is) => is())));
    answer = { decided, askers };
    const known = answer;
    decided.then(
      () => askers.clear(),
      () => answers.get(key) === known && answers.delete(key),
    );
  }
  answers.set(key, answer);
  for (const oldest of answers.keys()) {
    if (answers.size <= MOST_ANSWERS) break;
    answers.delete(oldest);
  }
  try {
    return await answer.decided;
  } catch (problem) {
    throw errorOf(problem);
  }
}

/** Who shows something says so, and when it is no longer shown calls what is returned. */
export function enter(): () => void {
  clearTimeout(leaving);
  users++;
  let here = true;
  return () => {
    if (!here) return;
    here = false;
    users--;
    if (users > 0) return;
    leaving = setTimeout(() => {
      pool?.close();
      pool = null;
    }, IDLE_MS);
  };
}
