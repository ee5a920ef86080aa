/** What all elements of a page share: the module, which is fetched once, and the workers that draw. */
import init, { LinkedMorph } from "../../pkg/frond-morph.js";
import { Pool } from "./pool";
import type { Answer, Job } from "./protocol";

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

async function unpacked(text: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/** The morph of a link. Free it. */
export async function morphOf(fragment: string): Promise<LinkedMorph> {
  await started();
  return new LinkedMorph(fragment);
}

/** Has a job done, after those that wait. */
export async function ask<J extends Job>(job: J): Promise<Answer<J>> {
  const compiled = await started();
  pool ??= new Pool(compiled);
  return pool.ask(job);
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
