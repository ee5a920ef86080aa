/** What the workers do, or the page itself where it may have none. */
import { LinkedMorph } from "../../pkg/frond-morph.js";
import * as bindings from "../../pkg/frond-proof.js";
import type { Answer, Decided, Drawing, Job, Question } from "./protocol";

/** Morphs that were drawn last: an element that plays asks for the same one again and again. */
const MOST_KEPT = 8;
const kept = new Map<string, LinkedMorph>();

/** Lets others have their turn. */
export type Breathe = () => Promise<void>;

/** Where a page has to answer in between, `breathe` is given, and long work is done in slices. */
export async function work<J extends Job>(job: J, breathe: Breathe | null = null): Promise<Answer<J>> {
  return (job.kind === "draw" ? draw(job.drawing) : await decide(job.question, breathe)) as Answer<J>;
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

type Bindings = Pick<
  typeof import("../../pkg/frond-proof.js"),
  "connectedness" | "LocusTiles" | "planPath" | "planPathIn"
>;
const scripts = new Map<string, Promise<Bindings>>();

async function decide({ proof, maps, to, mode, turns }: Question, breathe: Breathe | null): Promise<Decided> {
  const bound = await boundTo(proof);
  const ifs = (rows: number[][]) => ({ maps: rows }) as never;
  if (!to) return { connectedness: bound.connectedness(ifs(maps), undefined) };
  const options = { mode, ...(turns && turns.length > 0 ? { turns } : {}) };
  if (!breathe) return { plan: bound.planPath(ifs(maps), ifs(to), options as never) };
  return { plan: await inSlices(bound, ifs(maps), ifs(to), options, breathe) };
}

async function boundTo(proof: Question["proof"]): Promise<Bindings> {
  if ("module" in proof) {
    bindings.initSync({ module: proof.module });
    return bindings;
  }
  const { script } = proof;
  let loading = scripts.get(script);
  if (!loading) {
    loading = imported(script);
    scripts.set(script, loading);
    // What could not be had may be there the next time.
    loading.catch(() => scripts.delete(script));
  }
  return loading;
}

async function imported(script: string): Promise<Bindings> {
  const module: typeof import("../../pkg/frond-proof.js") = await import(
    /* @vite-ignore */ /* webpackIgnore: true */ /* turbopackIgnore: true */ script
  );
  await module.default();
  return module;
}

/** Samples a side of the locus that a path is sought in, a row in a slice. */
const SIDE = 97;

/** A path in the locus alone, without the finer grids and repairs of `planPath`, which cannot be left in between. */
async function inSlices(
  { LocusTiles, planPathIn }: Bindings,
  from: never,
  to: never,
  options: object,
  breathe: Breathe,
) {
  const size = { width: SIDE, height: SIDE };
  const tiles = new LocusTiles(from, to, { ...options, ...size } as never);
  try {
    const locus = { ...size, state: new Uint8Array(SIDE * SIDE), gap: new Float32Array(SIDE * SIDE) };
    for (let row = 0; row < SIDE; row++) {
      await breathe();
      const { state, gap } = tiles.run(row, row + 1, 1, true);
      locus.state.set(state, row * SIDE);
      locus.gap.set(gap, row * SIDE);
    }
    await breathe();
    return planPathIn(locus as never, undefined);
  } finally {
    tiles.free();
  }
}
