/** The set M: all complex s for which the shape of s z - 1 and s z + 1 is in one piece. */

import { nextKey } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import { STATE } from "#geometry/states";
import type { Connectedness, MapRow } from "#wasm/api";
import type { Channel, Job, Result, Task } from "#workers/pool/protocol";

export type Complex = [re: number, im: number];

/** Half the width of the part that is shown. */
export const REACH = 0.75;
export const BOUNDS = { u0: -REACH, v0: -REACH, u1: REACH, v1: REACH };
/** Below this size of s the shape is dust; from the other on it is in one piece. Between lies the question. */
export const DUST = 0.5;
export const WHOLE = Math.SQRT1_2;
export const EPSILON = 1e-4;
/** Samples a side of a patch. */
const PATCH = 60;

export function mapsOf([re, im]: Complex): MapRow[] {
  return [
    [re, -im, im, re, -1, 0],
    [re, -im, im, re, 1, 0],
  ];
}

/** What is known without looking, by the size of s alone; beyond the disc that is shown nothing is asked. */
export function knownState([re, im]: Complex): number | null {
  const size = Math.hypot(re, im);
  if (size > REACH) return STATE.pending;
  if (size < DUST) return STATE.disconnected;
  return size >= WHOLE ? STATE.connected : null;
}

function sampleAt(k: number, size: number): Complex {
  const at = (i: number) => (REACH * i) / (size - 1);
  return [at(k % size), at(Math.floor(k / size))];
}

/** A quarter of M: both parts of s from 0 to `REACH`. */
export function blankQuarter(size: number): LocusResult {
  const all = Array.from({ length: size * size }, (_, k) => sampleAt(k, size));
  return {
    width: size,
    height: size,
    state: Uint8Array.from(all, (s) => knownState(s) ?? STATE.pending),
    // Of pieces that are so small: their discs are apart by 1 - 2 |s| of the whole, if not by more.
    gap: Float32Array.from(all, ([re, im]) => Math.max(0, 1 - 2 * Math.hypot(re, im))),
    progress: 0,
    bounds: { u0: 0, v0: 0, u1: REACH, v1: REACH },
  };
}

/** All of M from a quarter: it is the same for s, its conjugate and its negative. */
export function unfolded({ width, state, gap, progress }: LocusResult): LocusResult {
  const size = 2 * width - 1;
  const whole = { state: new Uint8Array(size * size), gap: new Float32Array(size * size) };
  for (let k = 0; k < size * size; k++) {
    const column = Math.abs((k % size) - (width - 1));
    const row = Math.abs(Math.floor(k / size) - (width - 1));
    whole.state[k] = state[row * width + column] ?? STATE.pending;
    whole.gap[k] = gap[row * width + column] ?? Number.NaN;
  }
  return { ...whole, width: size, height: size, progress, bounds: BOUNDS };
}

/** Decides a quarter of M, in patches where the program can, else sample by sample. */
export function quarterJob(
  channel: Channel,
  size: number,
  families: boolean,
  show: (quarter: LocusResult) => void,
): Job<"patch" | "verdict"> {
  const quarter = blankQuarter(size);
  const key = nextKey();
  const patches = families ? tiles(size) : [];
  const points = families ? [] : [...openSamples(quarter)];
  const total = patches.length + points.length;
  const where = new Map<object, number>();
  let done = 0;
  // Unfolding and painting takes longer than deciding: a few times in all will do.
  const often = families ? 9 : 400;
  const tell = () => {
    done++;
    if (done % often === 0 || done === total) show({ ...quarter, progress: done / total });
  };
  const options = { bounds: quarter.bounds, width: size, height: size, epsilon: EPSILON };
  return {
    channel,
    priority: () => 34,
    next(): Task<"patch" | "verdict"> | null {
      const patch = patches.shift();
      if (patch) return { kind: "patch", key, of: { sides: 2, options }, ...patch };
      const point = points.shift();
      if (point === undefined) return null;
      const maps = mapsOf(sampleAt(point, size));
      const task: Task<"verdict"> = { kind: "verdict", maps, epsilon: EPSILON };
      where.set(task, point);
      return task;
    },
    accept(task, result) {
      if (task.kind === "patch") putPatch(quarter, task, result as Result<"patch">);
      else putPoint(quarter, where.get(task) ?? 0, result as Connectedness);
      where.delete(task);
      tell();
    },
    fail(task) {
      where.delete(task);
      tell();
    },
  };
}

function putPatch(quarter: LocusResult, { x0, y0, x1, y1 }: Task<"patch">, result: Result<"patch">): void {
  let k = 0;
  for (let row = y0; row < y1; row++) {
    for (let column = x0; column < x1; column++, k++) {
      const at = row * quarter.width + column;
      if (Math.hypot(...sampleAt(at, quarter.width)) > REACH) continue;
      quarter.state[at] = result.state[k] ?? STATE.pending;
      quarter.gap[at] = result.gap[k] ?? Number.NaN;
    }
  }
}

function putPoint(quarter: LocusResult, at: number, { verdict, gap, diameter }: Connectedness): void {
  const state = {
    connected: STATE.connected,
    touching: STATE.touching,
    disconnected: STATE.disconnected,
    undecided: STATE.undecided,
    "no-attractor": STATE.none,
  }[verdict];
  quarter.state[at] = state;
  quarter.gap[at] = diameter > 0 ? gap.upper / diameter : Number.NaN;
}

function* openSamples(quarter: LocusResult): Generator<number> {
  for (let at = 0; at < quarter.state.length; at++)
    if (knownState(sampleAt(at, quarter.width)) === null) yield at;
}

function tiles(size: number): { x0: number; y0: number; x1: number; y1: number }[] {
  const starts = Array.from({ length: Math.ceil(size / PATCH) }, (_, i) => i * PATCH);
  const end = (from: number) => Math.min(size, from + PATCH);
  return starts.flatMap((y0) => starts.map((x0) => ({ x0, y0, x1: end(x0), y1: end(y0) })));
}
