import { atResolution, STATE } from "#geometry/states";
import type { Locus } from "#wasm/api";

/** Samples a side. One less is divisible by 3, so that (0,0) and (1,1) are samples of every stride, too. */
export const SIZE = 121;
export const STRIDES = [8, 4, 2, 1] as const;
/** Pieces nearer than this count as touching: what 600 pixels show. */
export const EPSILON = 1 / 600;

/** A locus that is known ever more finely: each sample stands for the square around it until a finer one has come. */
export class LocusFill {
  readonly locus: Locus = {
    width: SIZE,
    height: SIZE,
    state: new Uint8Array(SIZE * SIZE).fill(STATE.pending),
    gap: new Float32Array(SIZE * SIZE).fill(Number.NaN),
  };

  /** Every `stride`th sample both ways of the rows from `r0` to before `r1`, as `SpaceLocus.run` gives them. */
  put(r0: number, r1: number, stride: number, { state, gap }: Pick<Locus, "state" | "gap">): void {
    const across = Math.ceil(SIZE / stride);
    for (let r = r0, k = 0; r < r1; r += stride) {
      for (let i = 0; i < across; i++, k++) {
        const g = gap[k] ?? Number.NaN;
        this.#spread(r, i * stride, stride, atResolution(state[k] ?? STATE.undecided, g, EPSILON), g);
      }
    }
  }

  #spread(row: number, column: number, stride: number, state: number, gap: number): void {
    const half = stride >> 1;
    const to = Math.min(SIZE, column - half + stride);
    for (let r = Math.max(0, row - half); r < Math.min(SIZE, row - half + stride); r++) {
      this.locus.state.fill(state, r * SIZE + Math.max(0, column - half), r * SIZE + to);
      this.locus.gap.fill(gap, r * SIZE + Math.max(0, column - half), r * SIZE + to);
    }
  }
}

/** How much of all the work is done once a stride has come to row `r`. */
export function shareOf(stage: number, r: number): number {
  const cost = (stride: number) => Math.ceil(SIZE / stride) ** 2;
  const all = STRIDES.reduce((sum, stride) => sum + cost(stride), 0);
  const done = STRIDES.slice(0, stage).reduce((sum, stride) => sum + cost(stride), 0);
  const now = STRIDES[stage];
  return now === undefined ? 1 : (done + cost(now) * Math.min(1, r / SIZE)) / all;
}
