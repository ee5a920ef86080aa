/** The locus of the whole plane, from coarse to fine, as tasks of workers. */
import { atAll, atResolution, STATE } from "#geometry/states";
import type { Bounds, FrondError, Locus, MapRow, MorphOptions } from "#wasm/api";
import type { Job, Result, Task } from "#workers/pool/protocol";
import { CELLS, homeOf } from "./window";

/** Samples a side. One less is divisible by 3, so (0,0) and (1,1) are samples, and by 4, so 127 and 64 nest in it. */
export const SIZE = CELLS + 1;
export const STRIDES = [4, 2, 1] as const;
/** What the document says of a picture: gaps that 600 pixels show. */
export const EPSILON = 1 / 600;
export const BOUNDS: Bounds = homeOf("morph");
/** Samples along a side of a patch. */
const PATCH = 64;
/** The same of the picture of every second sample, which moves with the hand. */
export const COARSE_SIZE = (SIZE - 1) / 2 + 1;
const COARSE_PATCH = 32;

export interface LocusInputs {
  from: MapRow[];
  to: MapRow[];
  options: MorphOptions;
}

interface LocusWatch {
  /** Some rows are in. */
  painted: (work: LocusWork) => void;
  /** All samples of a stride are in. */
  stage: (work: LocusWork, stride: number) => void;
  failed: (error: FrondError) => void;
}

/** Milliseconds a sample. */
export interface Pace {
  /** One by one. */
  alone: number;
  /** In patches. */
  patched: number;
}

interface LocusMeans {
  /** The stride of the picture that comes first, where patches follow; the coarsest where none is given. */
  first?: 2 | 4;
  /** About how long a sample takes, if that is known. */
  pace?: Pace;
  /** Whether the program decides whole rectangles at once: then they follow the coarsest stride, the middle first. */
  patches: boolean;
  /** How much it matters now, beside what else there is to do: the coarse picture, and what follows. */
  priorities: () => [coarse: number, fine: number];
}

/** The coarse picture is what the eye waits for; the fine one may wait for all that is seen sooner. */
const MEANS: LocusMeans = { patches: false, priorities: () => [50, 15] };

let keys = 0;

/** A number that no other locus has: workers tell by it what they have prepared. */
export const nextKey = (): number => ++keys;

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
  readonly #means: LocusMeans;
  readonly #key = nextKey();
  /** The strides that are gone through; with patches only the coarsest, and then all that is left. */
  readonly #strides: readonly number[];
  /** Samples still open, by stage. */
  readonly #open: number[];
  readonly #patches: Rectangle[];
  /** What is left of the coarse picture, where it is made of patches as well. */
  #coarsePatches: Rectangle[] = [];
  readonly #coarseKey = nextKey();
  /** The slice that is handed out next. */
  #stage = 0;
  #row = 0;
  /** Stages of which every sample is in, and of all coarser ones too. */
  #whole = 0;
  readonly pace: Pace;

  constructor(
    inputs: LocusInputs,
    watch: LocusWatch,
    sliceMilliseconds: () => number,
    means: LocusMeans = MEANS,
  ) {
    this.inputs = inputs;
    this.#watch = watch;
    this.#slice = sliceMilliseconds;
    this.#means = means;
    this.pace = means.pace ? { ...means.pace } : { alone: 0.02, patched: 0.01 };
    this.#patches = means.patches ? patchesOf(SIZE, PATCH) : [];
    const { first = STRIDES[0] } = means;
    if (means.patches && first === 2) this.#coarsePatches = patchesOf(COARSE_SIZE, COARSE_PATCH);
    this.#strides = means.patches ? [first, 1] : STRIDES;
    this.#open = means.patches
      ? [samplesOf(first, true), SIZE * SIZE - samplesOf(first, true)]
      : STRIDES.map((stride, stage) => samplesOf(stride, stage === 0));
  }

  job(): Job<Kinds> {
    return {
      channel: "locus",
      priority: () => this.#means.priorities()[this.#stage === 0 ? 0 : 1],
      next: () => {
        if (this.#coarsePatches.length > 0) return this.#nextCoarsePatch();
        return this.#means.patches && this.#stage > 0 ? this.#nextPatch() : this.#next();
      },
      accept: (task, result, milliseconds) =>
        task.kind === "patch"
          ? this.#acceptPatch(task, result, milliseconds)
          : this.#accept(task, result, milliseconds),
      fail: (_, error) => this.#watch.failed(error),
    };
  }

  /** What a worker is told of the samples of all strides. */
  whole(): Task<"patch">["of"] {
    return this.#options();
  }

  /** The states of a rectangle, row by row. */
  statesOf({ x0, y0, x1, y1 }: Rectangle): Uint8Array {
    const found = new Uint8Array((x1 - x0) * (y1 - y0));
    for (let r = y0, k = 0; r < y1; r++, k += x1 - x0)
      found.set(this.raw.state.subarray(r * SIZE + x0, r * SIZE + x1), k);
    return found;
  }

  /** The same, some of which are proved since. */
  prove({ x0, y0, x1, y1 }: Rectangle, states: Uint8Array): void {
    for (let r = y0, k = 0; r < y1; r++) {
      for (let c = x0; c < x1; c++, k++) {
        const at = r * SIZE + c;
        if (states[k] !== STATE.connected || this.raw.state[at] !== STATE.touching) continue;
        this.raw.state[at] = STATE.connected;
        this.filled.state[at] = STATE.connected;
      }
    }
  }

  #options(size = SIZE) {
    const { from, to, options } = this.inputs;
    return { from, to, options: { ...options, bounds: BOUNDS, width: size, height: size, epsilon: EPSILON } };
  }

  #nextCoarsePatch(): Task<"patch"> | null {
    const patch = this.#coarsePatches.shift();
    if (this.#coarsePatches.length === 0) this.#stage = 1;
    return patch ? { kind: "patch", key: this.#coarseKey, of: this.#options(COARSE_SIZE), ...patch } : null;
  }

  #nextPatch(): Task<"patch"> | null {
    const patch = this.#patches.shift();
    return patch ? { kind: "patch", key: this.#key, of: this.#options(), ...patch } : null;
  }

  #acceptPatch(
    { key, x0, y0, x1, y1 }: Task<"patch">,
    { state, gap }: Result<"patch">,
    milliseconds: number,
  ): void {
    const stride = key === this.#coarseKey ? 2 : 1;
    for (let y = y0, k = 0; y < y1; y++) {
      for (let x = x0; x < x1; x++, k++) {
        const [r, c] = [y * stride, x * stride];
        const [s, g] = [state[k] ?? STATE.undecided, gap[k] ?? Number.NaN];
        this.#take(r, c, s, g);
        if (stride > 1) this.#fill(r, c, stride, atResolution(s, g, EPSILON), g);
      }
    }
    this.pace.patched += 0.3 * (milliseconds / ((x1 - x0) * (y1 - y0)) - this.pace.patched);
    this.#tell();
  }

  /** All samples at once, from elsewhere. What is undecided there is left to the patches. */
  acceptWhole({ state, gap }: Pick<Locus, "state" | "gap">): void {
    for (let r = 0, k = 0; r < SIZE; r++) {
      for (let c = 0; c < SIZE; c++, k++) {
        const s = state[k] ?? STATE.undecided;
        if (s !== STATE.undecided && this.raw.state[k] === STATE.pending)
          this.#take(r, c, s, gap[k] ?? Number.NaN);
      }
    }
    // There is nothing left for a coarse picture to tell, and what is open is mostly in few places.
    this.#coarsePatches = [];
    if (this.#means.patches) this.#stage = Math.max(1, this.#stage);
    const open = patchesOf(SIZE, COARSE_PATCH).filter((patch) => this.#isOpen(patch));
    this.#patches.splice(0, this.#patches.length, ...open);
    this.#tell();
  }

  #isOpen({ x0, y0, x1, y1 }: Rectangle): boolean {
    for (let r = y0; r < y1; r++) {
      if (this.raw.state.subarray(r * SIZE + x0, r * SIZE + x1).includes(STATE.pending)) return true;
    }
    return false;
  }

  /** One sample. Those that are told twice count once. */
  #take(r: number, c: number, state: number, gap: number): void {
    const at = r * SIZE + c;
    if (this.raw.state[at] === STATE.pending) {
      const stage = this.#strides.findIndex((stride) => r % stride === 0 && c % stride === 0);
      this.#open[stage] = Math.max(0, (this.#open[stage] ?? 0) - 1);
    }
    const s = atResolution(state, gap, EPSILON);
    this.raw.state[at] = s;
    this.raw.gap[at] = gap;
    this.filled.state[at] = s;
    this.filled.gap[at] = gap;
  }

  #next(): Task<"locus"> | null {
    const stride = this.#strides[this.#stage];
    if (stride === undefined) return null;
    const first = this.#stage === 0;
    const across = Math.ceil(SIZE / stride) * (first ? 1 : 0.75);
    const rows = Math.max(1, Math.floor(this.#slice() / (across * this.pace.alone)));
    const r0 = this.#row;
    const r1 = Math.min(SIZE, r0 + rows * stride);
    this.#row = r1 + ((stride - (r1 % stride)) % stride);
    if (this.#row >= SIZE) {
      this.#stage++;
      this.#row = 0;
    }
    return { kind: "locus", key: this.#key, ...this.#options(), r0, r1, stride, first };
  }

  #accept(task: Task<"locus">, { state, gap }: Result<"locus">, milliseconds: number): void {
    const { r0, r1, stride } = task;
    let count = 0;
    for (let r = r0, from = 0; r < r1; r += stride, from += SIZE) {
      for (let c = 0; c < SIZE; c += stride) {
        const found = state[from + c];
        if (found === undefined || found === STATE.pending) continue;
        const g = gap[from + c] ?? Number.NaN;
        count++;
        this.#take(r, c, found, g);
        this.#fill(r, c, stride, atResolution(found, g, EPSILON), g);
      }
    }
    if (count > 0) this.pace.alone += 0.3 * (milliseconds / count - this.pace.alone);
    this.#tell();
  }

  /** Says how far it is. */
  #tell(): void {
    const left = this.#open.reduce((sum, n) => sum + n, 0);
    this.progress = 1 - left / (SIZE * SIZE);
    // A slice that a dying worker left behind may come after finer ones: a stage counts once the coarser ones do.
    while (this.#open[this.#whole] === 0) {
      this.coarse = true;
      this.#watch.stage(this, this.#strides[this.#whole++] ?? 1);
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

  /** The samples of a stride, as a locus of its own, for the program. */
  nested(stride: number): Locus {
    if (stride === 1) return { ...this.raw, state: this.raw.state.map(atAll), gap: this.raw.gap.slice() };
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
        locus.state[r * size + c] = atAll(this.raw.state[from] ?? STATE.undecided);
        locus.gap[r * size + c] = this.raw.gap[from] ?? Number.NaN;
      }
    }
    return locus;
  }
}

type Kinds = "locus" | "patch";

export interface Rectangle {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** Rectangles that cover a square of samples, the nearest to its middle first. */
export function patchesOf(size: number, side: number): Rectangle[] {
  const count = Math.ceil(size / side);
  const edge = (k: number) => Math.round((k * size) / count);
  const all: Rectangle[] = [];
  for (let j = 0; j < count; j++) {
    for (let i = 0; i < count; i++) {
      all.push({ x0: edge(i), y0: edge(j), x1: edge(i + 1), y1: edge(j + 1) });
    }
  }
  const far = ({ x0, y0, x1, y1 }: Rectangle) => Math.hypot(x0 + x1 - size, y0 + y1 - size);
  return all.sort((p, q) => far(p) - far(q));
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
