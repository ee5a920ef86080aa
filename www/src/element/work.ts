/** What the workers do, or the page itself where it may have none. */
import { LinkedMorph } from "../../pkg/frond-morph.js";
import type { Answer, Decided, Drawing, Job, Question } from "./protocol";

/** Morphs that were drawn last: an element that plays asks for the same one again and again. */
const MOST_KEPT = 8;
const kept = new Map<string, LinkedMorph>();

export async function work<J extends Job>(job: J): Promise<Answer<J>> {
  return (job.kind === "draw" ? draw(job.drawing) : await decide(job.question)) as Answer<J>;
}

function draw({ fragment, at, width, height, view, palette }: Drawing): Uint8ClampedArray {
  const morph = kept.get(fragment) ?? new LinkedMorph(fragment);
  kept.delete(fragment);
  kept.set(fragment, morph);
  for (const [oldest, forgotten] of kept) {
    if (kept.size <= MOST_KEPT) break;
    forgotten.free();
    kept.delete(oldest);
  }
  const colours = Uint32Array.from(palette);
  const bytes = morph.draw(...at, width, height, view.x, view.y, view.scale, colours);
  return new Uint8ClampedArray(bytes.buffer as ArrayBuffer, bytes.byteOffset, bytes.byteLength);
}

type Proof = typeof import("../../pkg/frond-proof.js");
const modules = new Map<string, Promise<Proof>>();

async function decide({ module, maps, to, mode, turns }: Question): Promise<Decided> {
  let loading = modules.get(module);
  if (!loading) {
    loading = fetched(module);
    modules.set(module, loading);
    // What could not be had may be there the next time.
    loading.catch(() => modules.delete(module));
  }
  const proof = await loading;
  const ifs = (rows: number[][]) => ({ maps: rows }) as never;
  if (!to) return { connectedness: proof.connectedness(ifs(maps), undefined) };
  const options = { mode, ...(turns && turns.length > 0 ? { turns } : {}) };
  return { plan: proof.planPath(ifs(maps), ifs(to), options as never) };
}

async function fetched(module: string): Promise<Proof> {
  const proof: Proof = await import(/* @vite-ignore */ module);
  await proof.default();
  return proof;
}
