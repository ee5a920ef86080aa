/** The samples of the window that is looked at: a coarse picture first, then tile by tile from the middle outwards. */

import { fills } from "#geometry/maps/polygon-family";
import { atResolution, STATE } from "#geometry/states";
import type { Bounds, FrondError, LocusView } from "#wasm/api";
import type { Job, Result, Task } from "#workers/pool/protocol";
import { nextKey } from "./job";
import { type Pyramid, type Samples, type Span, STEP, TILE, type TileId, WHOLE_LEVELS } from "./pyramid";
import { epsilonOf, homeOf, samplesAt, windowOf } from "./window";

interface WindowWatch {
  /** Some samples are in. */
  painted: () => void;
  /** Something is known everywhere in the window. */
  coarse: () => void;
  failed: (error: FrondError) => void;
}

type Kinds = "patch" | "locus";

interface Slice {
  id: TileId;
  what: "coarse" | "fine";
  /** Rows of the tile, where it is done in parts. */
  rows: [from: number, to: number];
}

/** Rows of a tile in a slice, where whole boxes cannot be decided at once. */
const ROWS = 16;

const NONE = { done: 0, state: new Uint8Array(0), gap: new Float32Array(0) };

export class WindowWork {
  readonly pyramid: Pyramid;
  readonly started = performance.now();
  readonly #watch: WindowWatch;
  /** Whether the program decides rectangles at once. */
  readonly #patches: boolean;
  readonly #slices = new WeakMap<object, Slice>();
  readonly #gridKeys = new Map<string, number>();
  #coarse: TileId[] = [];
  #fine: TileId[] = [];
  /** Tiles that are handed out and not back, or handed out in part. */
  readonly #under = new Map<string, { rows: number; done: number; state: Uint8Array; gap: Float32Array }>();
  #coarseLeft = 0;
  #count = 0;
  #view: LocusView | null = null;
  #detail = 1;

  constructor(pyramid: Pyramid, watch: WindowWatch, patches: boolean) {
    this.pyramid = pyramid;
    this.#watch = watch;
    this.#patches = patches;
  }

  /** 0 to 1, over the window. */
  get progress(): number {
    if (!this.#view || this.#count === 0) return 1;
    const { fine } = this.pyramid.missing(windowOf(this.#view), this.#view.zoom * this.#detail);
    return 1 - fine.length / this.#count;
  }

  /** Whether something is known everywhere in the window. */
  get seen(): boolean {
    return this.#coarseLeft === 0;
  }

  /** Looks elsewhere: what was wanted and is not begun is forgotten. Says whether there is anything to do. */
  want(view: LocusView, detail = 1): boolean {
    this.#view = view;
    this.#detail = detail;
    const { coarse, fine, count } = this.pyramid.missing(windowOf(view), view.zoom * detail);
    this.#coarse = coarse.filter((id) => !this.#under.has(name(id, "coarse")));
    this.#coarseLeft = coarse.length;
    this.#fine = fine.filter((id) => this.#begun(id) < this.pyramid.place(id).height);
    this.#count = count;
    return this.#coarse.length + this.#fine.length > 0;
  }

  /** Rows of a tile that are handed out: those of one that was left half done are not asked for twice. */
  #begun(id: TileId): number {
    return this.#under.get(name(id, "fine"))?.rows ?? 0;
  }

  /** Tiles that are wanted and not begun, the middle first. */
  get open(): TileId[] {
    return this.#fine.filter((id) => this.#begun(id) === 0);
  }

  /** Somebody else than the workers has taken them. */
  hold(ids: readonly TileId[]): void {
    const others = (id: TileId) => !ids.includes(id);
    this.#coarse = this.#coarse.filter(others);
    this.#fine = this.#fine.filter(others);
    for (const id of ids) this.#under.set(name(id, "fine"), { ...NONE, rows: TILE });
  }

  /** Those that are held are the workers' again. */
  release(ids: readonly TileId[]): void {
    const held = ids.filter((id) => this.#under.get(name(id, "fine"))?.state === NONE.state);
    for (const id of held) this.#under.delete(name(id, "fine"));
    this.#fine.push(...held);
  }

  /** The samples of tiles that were held; what a worker may say of them still is not heard. */
  put(tiles: readonly { id: TileId; samples: Samples }[]): void {
    for (const { id, samples } of tiles) {
      this.#under.delete(name(id, "fine"));
      this.pyramid.put(id, "fine", samples);
    }
    this.#tell();
    if (this.#view) this.want(this.#view, this.#detail);
  }

  /** Samples of a level as a plane of their own. */
  planeOf(level: number, span: Span): Task<"patch">["of"] {
    const [width, height] = [span.x1 - span.x0 + 1, span.y1 - span.y0 + 1];
    return this.#of(this.pyramid.boundsOf(level, span), width, height, level);
  }

  job(): Job<Kinds> {
    return {
      channel: "window",
      priority: () => (this.#coarse.length > 0 ? 52 : 20),
      next: () => this.#next(),
      accept: (task, result) => this.#accept(task, result),
      fail: (_, error) => this.#watch.failed(error),
    };
  }

  #next(): Task<Kinds> | null {
    const coarse = this.#coarse.shift();
    if (coarse) {
      const { height } = this.pyramid.place(coarse);
      return this.#task({ id: coarse, what: "coarse", rows: [0, Math.ceil(height / STEP)] });
    }
    const fine = this.#fine[0];
    if (!fine) return null;
    const { height } = this.pyramid.place(fine);
    const from = this.#begun(fine);
    const to = this.#patches ? height : Math.min(height, from + ROWS);
    if (to >= height) this.#fine.shift();
    return this.#task({ id: fine, what: "fine", rows: [from, to] });
  }

  #task(slice: Slice): Task<Kinds> {
    const { id, what, rows } = slice;
    const place = this.pyramid.place(id);
    const thin = what === "fine" ? 1 : STEP;
    const [width, height] = [Math.ceil(place.width / thin), Math.ceil(place.height / thin)];
    const under = this.#under.get(name(id, what)) ?? {
      rows: 0,
      done: 0,
      state: new Uint8Array(width * height),
      gap: new Float32Array(width * height),
    };
    under.rows = rows[1];
    this.#under.set(name(id, what), under);
    const task =
      this.#patches && id.level <= WHOLE_LEVELS
        ? this.#patchOfWhole(id, thin)
        : this.#ofOwnGrid(id, thin, width, height, rows);
    this.#slices.set(task, slice);
    return task;
  }

  /** What a worker is told of a tile: a grid, and where on it the tile begins. */
  gridOf(id: TileId): Pick<Task<"patch">, "key" | "of" | "x0" | "y0"> {
    const { x0, y0, width, height } = this.pyramid.place(id);
    if (id.level <= WHOLE_LEVELS) return { ...this.#patchOfWhole(id), x0, y0 };
    const span = { x0, y0, x1: x0 + width - 1, y1: y0 + height - 1 };
    return { key: nextKey(), of: this.planeOf(id.level, span), x0: 0, y0: 0 };
  }

  /**
   * One grid over all, or over every few samples: those fall on 0 and 1 exactly, and the worker prepares it once. Tiles
   * begin at whole steps of it.
   */
  #patchOfWhole(id: TileId, thin = 1): Task<"patch"> {
    const size = (samplesAt(id.level) - 1) / thin + 1;
    const grid = `${id.level}/${thin}`;
    const key = this.#gridKeys.get(grid) ?? nextKey();
    this.#gridKeys.set(grid, key);
    const place = this.pyramid.place(id);
    const [x0, y0] = [place.x0 / thin, place.y0 / thin];
    const of = this.#of(homeOf(this.pyramid.family), size, size, id.level);
    const [x1, y1] = [x0 + Math.ceil(place.width / thin), y0 + Math.ceil(place.height / thin)];
    return { kind: "patch", key, of, x0, y0, x1, y1 };
  }

  #ofOwnGrid(id: TileId, thin: number, width: number, height: number, rows: [number, number]): Task<Kinds> {
    const { x0, y0 } = this.pyramid.place(id);
    const span = { x0, y0, x1: x0 + (width - 1) * thin, y1: y0 + (height - 1) * thin };
    const of = this.#of(this.pyramid.boundsOf(id.level, span), width, height, id.level);
    const key = nextKey();
    if (this.#patches || "sides" in of)
      return { kind: "patch", key, of, x0: 0, y0: 0, x1: width, y1: height };
    const [r0, r1] = rows;
    return { kind: "locus", key, ...of, r0, r1, stride: 1, first: true };
  }

  #of(bounds: Bounds, width: number, height: number, level: number): Task<"patch">["of"] {
    const { source } = this.pyramid;
    const epsilon = epsilonOf(level);
    if (source.family === "polygon")
      return { sides: source.sides, options: { bounds, width, height, epsilon } };
    const { from, to, options } = source.inputs;
    return { from, to, options: { ...options, bounds, width, height, epsilon, w: source.w } };
  }

  #accept(task: Task<Kinds>, { state, gap }: Result<Kinds>): void {
    const slice = this.#slices.get(task);
    const under = slice && this.#under.get(name(slice.id, slice.what));
    if (!slice || !under) return;
    const { id, what, rows } = slice;
    const place = this.pyramid.place(id);
    const width = what === "fine" ? place.width : Math.ceil(place.width / STEP);
    const height = what === "fine" ? place.height : Math.ceil(place.height / STEP);
    const first = rows[0] * width;
    const part = { state: under.state.subarray(first), gap: under.gap.subarray(first) };
    const proved = task.kind === "patch" ? provedIn(task) : () => false;
    judge({ state, gap }, part, epsilonOf(id.level), proved);
    under.done += rows[1] - rows[0];
    if (under.done < height) return;
    this.#under.delete(name(id, what));
    this.pyramid.put(id, what, { width, state: under.state, gap: under.gap });
    this.#tell();
  }

  #tell(): void {
    if (this.#coarseLeft > 0 && this.#view) {
      const { coarse } = this.pyramid.missing(windowOf(this.#view), this.#view.zoom * this.#detail);
      this.#coarseLeft = coarse.length;
      if (coarse.length === 0) this.#watch.coarse();
    }
    this.#watch.painted();
  }
}

/** Writes what is said of samples at an epsilon, where some are `proved` in one piece whatever a search says. */
export function judge(
  found: Result<"patch">,
  { state, gap }: Result<"patch">,
  epsilon: number,
  proved: (k: number) => boolean,
): void {
  for (let k = 0; k < found.state.length; k++) {
    const g = found.gap[k] ?? Number.NaN;
    const said = atResolution(found.state[k] ?? STATE.undecided, g, epsilon);
    const open = said === STATE.touching || said === STATE.undecided;
    state[k] = open && proved(k) ? STATE.connected : said;
    gap[k] = g;
  }
}

/** Which samples of a tile of a family are in one piece whatever a search says. */
export function provedIn({
  x0,
  y0,
  x1,
  of,
}: Pick<Task<"patch">, "x0" | "y0" | "x1" | "of">): (k: number) => boolean {
  if (!("sides" in of)) return () => false;
  const { bounds, width, height } = of.options;
  const at = (low: number, high: number, k: number, count: number) => low + ((high - low) * k) / (count - 1);
  return (k) => {
    const column = x0 + (k % (x1 - x0));
    const row = y0 + Math.floor(k / (x1 - x0));
    return fills(of.sides, [at(bounds.u0, bounds.u1, column, width), at(bounds.v0, bounds.v1, row, height)]);
  };
}

const name = ({ level, i, j }: TileId, what: "coarse" | "fine"): string => `${what}/${level}/${i}/${j}`;
