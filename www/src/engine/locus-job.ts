import type { Bounds, FrondError, Locus, MapRow, MorphOptions } from "./api";
import { atResolution, STATE } from "./breaks";
import type { Job, Result, Task } from "./protocol";

/** Samples a side. One less is divisible by 3, so (0,0) and (1,1) are samples, and by 4, so 127 and 64 nest in it. */
export const SIZE = 253;
export const STRIDES = [4, 2, 1] as const;
/** What the document says of a picture: gaps that 600 pixels show. */
export const EPSILON = 1 / 600;
export const BOUNDS: Bounds = { u0: -1, v0: -1, u1: 2, v1: 2 };

export interface LocusInputs {
  from: MapRow[];
  to: MapRow[];
  options: MorphOptions;
}

export interface LocusWatch {
  /** Some rows are in. */
  painted: (work: LocusWork) => void;
  /** All samples of a stride are in. */
  stage: (work: LocusWork, stride: number) => void;
  failed: (error: FrondError) => void;
}

let keys = 0;

/** One locus on its way from coarse to fine. */
export class LocusWork {
  readonly inputs: LocusInputs;
  readonly started = performance.now();
  /** What is decided: 255 and NaN elsewhere. */
  readonly raw: Locus = blank();
  /** The same with each sample spread over the finer ones that are still open, for painting. */
  readonly filled: Locus = blank();
  progress = 0;
  coarse = false;
  readonly #watch: LocusWatch;
  readonly #slice: () => number;
  readonly #key = ++keys;
  /** Samples still open, by stage. */
  readonly #open = STRIDES.map((stride, stage) => samplesOf(stride, stage === 0));
  /** The slice that is handed out next. */
  #stage = 0;
  #row = 0;
  /** Stages of which every sample is in, and of all coarser ones too. */
  #whole = 0;
  /** A guess until the first slices are back. */
  #msPerSample = 0.02;

  constructor(inputs: LocusInputs, watch: LocusWatch, sliceMilliseconds: () => number) {
    this.inputs = inputs;
    this.#watch = watch;
    this.#slice = sliceMilliseconds;
  }

  job(): Job<"locus"> {
    return {
      channel: "locus",
      // The coarse picture is what the eye waits for; the fine one may wait for all that is seen sooner.
      priority: () => (this.#stage === 0 ? 50 : 15),
      next: () => this.#next(),
      accept: (task, result, milliseconds) => this.#accept(task, result, milliseconds),
      fail: (_, error) => this.#watch.failed(error),
    };
  }

  #next(): Task<"locus"> | null {
    const stride = STRIDES[this.#stage];
    if (stride === undefined) return null;
    const first = this.#stage === 0;
    const across = Math.ceil(SIZE / stride) * (first ? 1 : 0.75);
    const rows = Math.max(1, Math.floor(this.#slice() / (across * this.#msPerSample)));
    const r0 = this.#row;
    const r1 = Math.min(SIZE, r0 + rows * stride);
    this.#row = r1 + ((stride - (r1 % stride)) % stride);
    if (this.#row >= SIZE) {
      this.#stage++;
      this.#row = 0;
    }
    const { from, to, options } = this.inputs;
    const all = { ...options, bounds: BOUNDS, width: SIZE, height: SIZE, epsilon: EPSILON };
    return { kind: "locus", key: this.#key, from, to, options: all, r0, r1, stride, first };
  }

  #accept(task: Task<"locus">, { state, gap }: Result<"locus">, milliseconds: number): void {
    const { r0, r1, stride, first } = task;
    let count = 0;
    for (let r = r0, from = 0; r < r1; r += stride, from += SIZE) {
      for (let c = 0; c < SIZE; c += stride) {
        const found = state[from + c];
        if (found === undefined || found === STATE.pending) continue;
        const s = atResolution(found, gap[from + c] ?? Number.NaN, EPSILON);
        count++;
        this.raw.state[r * SIZE + c] = s;
        this.raw.gap[r * SIZE + c] = gap[from + c] ?? Number.NaN;
        this.#fill(r, c, stride, s, gap[from + c] ?? Number.NaN);
      }
    }
    const stage = first ? 0 : STRIDES.indexOf(stride as 4 | 2 | 1);
    this.#open[stage] = Math.max(0, (this.#open[stage] ?? 0) - count);
    const left = this.#open.reduce((sum, n) => sum + n, 0);
    this.progress = 1 - left / (SIZE * SIZE);
    if (count > 0) this.#msPerSample += 0.3 * (milliseconds / count - this.#msPerSample);
    // A slice that a dying worker left behind may come after finer ones: a stage counts once the coarser ones do.
    while (this.#open[this.#whole] === 0) {
      this.coarse = true;
      this.#watch.stage(this, STRIDES[this.#whole++] ?? 1);
    }
    this.#watch.painted(this);
  }

  /** A sample speaks for the square around it, but not where a finer one has spoken. */
  #fill(row: number, column: number, stride: number, state: number, gap: number): void {
    const half = stride >> 1;
    const own = row * SIZE + column;
    for (let r = Math.max(0, row - half); r < Math.min(SIZE, row - half + stride); r++) {
      for (let c = Math.max(0, column - half); c < Math.min(SIZE, column - half + stride); c++) {
        const at = r * SIZE + c;
        if (at !== own && this.raw.state[at] !== STATE.pending) continue;
        this.filled.state[at] = state;
        this.filled.gap[at] = gap;
      }
    }
  }

  /** The samples of a stride, as a locus of its own. */
  nested(stride: number): Locus {
    if (stride === 1) return { ...this.raw, state: this.raw.state.slice(), gap: this.raw.gap.slice() };
    const size = (SIZE - 1) / stride + 1;
    const locus: Locus = {
      width: size,
      height: size,
      state: new Uint8Array(size * size),
      gap: new Float32Array(size * size),
    };
    for (let r = 0; r < size; r++) {
      for (let c = 0; c < size; c++) {
        const from = r * stride * SIZE + c * stride;
        locus.state[r * size + c] = this.raw.state[from] ?? STATE.undecided;
        locus.gap[r * size + c] = this.raw.gap[from] ?? Number.NaN;
      }
    }
    return locus;
  }
}

function blank(): Locus {
  return {
    width: SIZE,
    height: SIZE,
    state: new Uint8Array(SIZE * SIZE).fill(STATE.pending),
    gap: new Float32Array(SIZE * SIZE).fill(Number.NaN),
  };
}

function samplesOf(stride: number, first: boolean): number {
  const side = (SIZE - 1) / stride + 1;
  const coarser = (SIZE - 1) / (2 * stride) + 1;
  return side * side - (first ? 0 : coarser * coarser);
}
