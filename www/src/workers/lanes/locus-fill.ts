/** A locus that a worker decides row by row, from coarse to fine. */
import { atResolution, STATE } from "#geometry/states";
import type { Locus } from "#wasm/api";
import type { Context } from "./task";

/** How finely it is decided. */
export interface Fineness {
  /** Samples a side. One less is divisible by 3, so that (0,0) and (1,1) are samples of every stride, too. */
  size: number;
  strides: readonly number[];
  /** A finer stride is not begun where it would take longer than so many milliseconds. */
  patience: number;
}

/** Where a sample takes less than a millisecond, and where it takes some. */
export const FINE: Fineness = { size: 121, strides: [8, 4, 2, 1], patience: Number.POSITIVE_INFINITY };
export const COARSE: Fineness = { size: 61, strides: [4, 2, 1], patience: 40_000 };
/** Pieces nearer than this count as touching: what 600 pixels show. */
export const EPSILON = 1 / 600;

export interface LocusSoFar extends Locus {
  /** 0 to 1. */
  progress: number;
  /** The stride of the samples that are seen everywhere. At the end it is 1, or finer ones would take too long. */
  stride: number;
}

/** Every `stride`th sample both ways of the rows from r0 to before r1. */
type Decide = (r0: number, r1: number, stride: number) => Pick<Locus, "state" | "gap">;

/** Milliseconds from breath to breath. */
export const BREATH = 60;

/** Decides all of a locus, and tells after each breath what is known. */
export async function fillLocus(
  { progress, breathe, transfer }: Context<LocusSoFar>,
  fineness: Fineness,
  decide: Decide,
): Promise<LocusSoFar> {
  const { size, strides, patience } = fineness;
  const fill = new LocusFill(size);
  let seen = strides[0] ?? 1;
  const copy = (share: number): LocusSoFar => ({
    ...fill.locus,
    state: fill.locus.state.slice(),
    gap: fill.locus.gap.slice(),
    progress: share,
    stride: seen,
  });
  let perRow = 1;
  let perSample = 0;
  for (const [stage, stride] of strides.entries()) {
    const samples = Math.ceil(size / stride) ** 2;
    if (perSample * samples > patience) break;
    let spent = 0;
    for (let r0 = 0; r0 < size; ) {
      const rows = Math.max(1, Math.round(BREATH / perRow));
      const r1 = Math.min(size, r0 + rows * stride);
      const before = performance.now();
      fill.put(r0, r1, stride, decide(r0, r1, stride));
      const took = performance.now() - before;
      perRow = Math.max(0.05, took / rows);
      spent += took;
      r0 = r1 + ((stride - (r1 % stride)) % stride);
      const now = copy(shareOf(fineness, stage, r0));
      progress(now, [now.state.buffer, now.gap.buffer]);
      await breathe();
    }
    seen = stride;
    perSample = spent / samples;
  }
  const whole = copy(1);
  transfer(whole.state.buffer, whole.gap.buffer);
  return whole;
}

/** A locus that is known ever more finely: each sample stands for the square around it until a finer one has come. */
export class LocusFill {
  readonly locus: Locus;
  readonly #size: number;

  constructor(size: number) {
    this.#size = size;
    this.locus = {
      width: size,
      height: size,
      state: new Uint8Array(size * size).fill(STATE.pending),
      gap: new Float32Array(size * size).fill(Number.NaN),
    };
  }

  /** Every `stride`th sample both ways of the rows from `r0` to before `r1`. */
  put(r0: number, r1: number, stride: number, { state, gap }: Pick<Locus, "state" | "gap">): void {
    const across = Math.ceil(this.#size / stride);
    for (let r = r0, k = 0; r < r1; r += stride) {
      for (let i = 0; i < across; i++, k++) {
        const g = gap[k] ?? Number.NaN;
        this.#spread(r, i * stride, stride, atResolution(state[k] ?? STATE.undecided, g, EPSILON), g);
      }
    }
  }

  #spread(row: number, column: number, stride: number, state: number, gap: number): void {
    const half = stride >> 1;
    const size = this.#size;
    const to = Math.min(size, column - half + stride);
    for (let r = Math.max(0, row - half); r < Math.min(size, row - half + stride); r++) {
      this.locus.state.fill(state, r * size + Math.max(0, column - half), r * size + to);
      this.locus.gap.fill(gap, r * size + Math.max(0, column - half), r * size + to);
    }
  }
}

/** How much of all the work is done once a stride has come to row `r`. */
export function shareOf({ size, strides }: Fineness, stage: number, r: number): number {
  const cost = (stride: number) => Math.ceil(size / stride) ** 2;
  const all = strides.reduce((sum, stride) => sum + cost(stride), 0);
  const done = strides.slice(0, stage).reduce((sum, stride) => sum + cost(stride), 0);
  const now = strides[stage];
  return now === undefined ? 1 : (done + cost(now) * Math.min(1, r / size)) / all;
}
