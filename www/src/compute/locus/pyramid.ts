/** Samples of a plane of parameters at every fineness that was looked at, in tiles. */

import { STATE } from "#geometry/states";
import type { Bounds, Locus } from "#wasm/api";
import type { LocusInputs } from "./job";
import { CELLS, epsilonOf, type Family, homeOf, levelOf, parameterAt, samplesAt } from "./window";

/** Samples along a side of a tile; of the coarse picture of one, every fourth. */
export const TILE = 64;
export const STEP = 4;
/** Tiles kept: some 20 kB each. */
const MOST_TILES = 768;
/** Coarser tiles that are looked through for something to show; what is coarser yet shows nothing that is of use. */
const FARTHEST = 10;

/** What is mapped. */
export type LocusSource =
  | { family: "morph"; inputs: LocusInputs; w: number }
  | { family: "polygon"; sides: number };

export interface TileId {
  level: number;
  i: number;
  j: number;
}

interface Tile extends TileId {
  width: number;
  height: number;
  /** Every fourth sample both ways, from the first. */
  coarse: Samples | null;
  fine: Samples | null;
}

interface Samples {
  width: number;
  state: Uint8Array;
  gap: Float32Array;
}

/** Samples over a window, as finely as they are known. */
export interface Field extends Locus {
  /** Of the outermost samples. */
  bounds: Bounds;
  /** The least gap that counts there. */
  epsilon: number;
}

/** A rectangle of samples of a level, ends included. */
export interface Span {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

const keyOf = ({ level, i, j }: TileId): string => `${level}/${i}/${j}`;

/** A whole plane at level 0, and how much of it is known. */
export type Base = Locus & { progress: number };

export class Pyramid {
  readonly source: LocusSource;
  readonly #tiles = new Map<string, Tile>();
  readonly #base: () => Base | null;
  #previous: Pyramid | null;

  /**
   * `base` is the whole plane at level 0, where somebody else keeps it; then there are no tiles of that level. What is
   * not known yet is shown as the `previous` plane had it, until `forget`.
   */
  constructor(source: LocusSource, base: (() => Base | null) | null = null, previous: Pyramid | null = null) {
    this.source = source;
    this.#base = base ?? (() => null);
    this.#previous = previous;
    this.based = base !== null;
    // Only one step back: a long drag would chain them without end.
    if (previous) previous.#previous = null;
  }

  /** Whether level 0 is kept elsewhere. */
  readonly based: boolean;

  get family(): Family {
    return this.source.family;
  }

  forget(): void {
    this.#previous = null;
  }

  /** The samples that a window needs. */
  span(window: Bounds, level: number): Span {
    const home = homeOf(this.family);
    const last = samplesAt(level) - 1;
    const cell = (home.u1 - home.u0) / last;
    const within = (k: number) => Math.min(last, Math.max(0, k));
    return {
      x0: within(Math.floor((window.u0 - home.u0) / cell)),
      y0: within(Math.floor((window.v0 - home.v0) / cell)),
      x1: within(Math.ceil((window.u1 - home.u0) / cell)),
      y1: within(Math.ceil((window.v1 - home.v0) / cell)),
    };
  }

  /** Tiles of a window that are not there yet, the nearest to its middle first. */
  missing(window: Bounds, zoom: number): { coarse: TileId[]; fine: TileId[]; count: number } {
    const level = levelOf(zoom);
    if (level === 0 && this.based) return { coarse: [], fine: [], count: 0 };
    const { x0, y0, x1, y1 } = this.span(window, level);
    const at = (k: number) => Math.floor(k / TILE);
    const [cx, cy] = [(x0 + x1) / 2, (y0 + y1) / 2];
    const all: { id: TileId; far: number }[] = [];
    for (let j = at(y0); j <= at(y1); j++) {
      for (let i = at(x0); i <= at(x1); i++) {
        const far = Math.hypot((i + 0.5) * TILE - cx, (j + 0.5) * TILE - cy);
        all.push({ id: { level, i, j }, far });
      }
    }
    all.sort((p, q) => p.far - q.far);
    const fine = all.map(({ id }) => id).filter((id) => !this.#tiles.get(keyOf(id))?.fine);
    const coarse = fine.filter((id) => !this.#tiles.get(keyOf(id))?.coarse && !this.#seen(id));
    return { coarse, fine, count: all.length };
  }

  /** Whether a picture that is as good as the coarse one is there already. */
  #seen({ level, i, j }: TileId): boolean {
    for (let k = 1; k <= Math.min(2, level); k++) {
      if (k === level && this.based) return this.#base()?.progress === 1;
      const above = { level: level - k, i: Math.floor(i / 2 ** k), j: Math.floor(j / 2 ** k) };
      if (this.#tiles.get(keyOf(above))?.fine) return true;
    }
    return false;
  }

  /** Where a tile lies. The last ones of a plane are smaller. */
  place({ level, i, j }: TileId): { x0: number; y0: number; width: number; height: number } {
    const all = samplesAt(level);
    const [x0, y0] = [i * TILE, j * TILE];
    return { x0, y0, width: Math.min(TILE, all - x0), height: Math.min(TILE, all - y0) };
  }

  /** The bounds of samples `x0` .. and `y0` .. of a level. */
  boundsOf(level: number, { x0, y0, x1, y1 }: Span): Bounds {
    const { u0, v0, u1, v1 } = homeOf(this.family);
    return {
      u0: parameterAt(u0, u1, level, x0),
      v0: parameterAt(v0, v1, level, y0),
      u1: parameterAt(u0, u1, level, x1),
      v1: parameterAt(v0, v1, level, y1),
    };
  }

  put(id: TileId, what: "coarse" | "fine", samples: Samples): void {
    const key = keyOf(id);
    const { width, height } = this.place(id);
    const tile = this.#tiles.get(key) ?? { ...id, width, height, coarse: null, fine: null };
    tile[what] = samples;
    // The newest last: the first of the map is the one to go.
    this.#tiles.delete(key);
    this.#tiles.set(key, tile);
    for (const oldest of this.#tiles.keys()) {
      if (this.#tiles.size <= MOST_TILES) break;
      this.#tiles.delete(oldest);
    }
  }

  /** What is known of a window, at the fineness of its zoom: coarser samples stand in for those that are missing. */
  read(window: Bounds, zoom: number): Field {
    const level = levelOf(zoom);
    const span = this.span(window, level);
    const width = span.x1 - span.x0 + 1;
    const height = span.y1 - span.y0 + 1;
    const field: Field = {
      width,
      height,
      state: new Uint8Array(width * height).fill(STATE.pending),
      gap: new Float32Array(width * height).fill(Number.NaN),
      bounds: this.boundsOf(level, span),
      epsilon: epsilonOf(level),
    };
    const at = (k: number) => Math.floor(k / TILE);
    for (let j = at(span.y0); j <= at(span.y1); j++) {
      for (let i = at(span.x0); i <= at(span.x1); i++) {
        const id = { level, i, j };
        const before = this.#previous ?? this;
        if (this.#copy(id, span, field) || before.#copy(id, span, field)) continue;
        const base = this.based && level <= FARTHEST ? this.#base() : null;
        if (!base) continue;
        const whole = {
          level: 0,
          i: 0,
          j: 0,
          width: base.width,
          height: base.height,
          coarse: null,
          fine: base,
        };
        this.#lay(id, span, field, whole, 2 ** level);
      }
    }
    return field;
  }

  /** Copies the best tile that is known of a place into a field. */
  #copy(id: TileId, span: Span, field: Field): boolean {
    const { level, i, j } = id;
    for (let k = 0; k <= Math.min(FARTHEST, level); k++) {
      if (k === level && this.based) break;
      const step = 2 ** k;
      const tile = this.#tiles.get(
        keyOf({ level: level - k, i: Math.floor(i / step), j: Math.floor(j / step) }),
      );
      if (!tile?.fine && !tile?.coarse) continue;
      this.#lay(id, span, field, tile, step);
      return true;
    }
    return false;
  }

  #lay(id: TileId, span: Span, field: Field, tile: Tile, step: number): void {
    const from = tile.fine ?? tile.coarse;
    if (!from) return;
    const thin = tile.fine ? 1 : STEP;
    const place = this.place(id);
    const [left, bottom] = [tile.i * TILE, tile.j * TILE];
    const index = (k: number, first: number, count: number) =>
      Math.min(Math.ceil(count / thin) - 1, Math.max(0, Math.round((k / step - first) / thin)));
    const x0 = Math.max(place.x0, span.x0);
    const x1 = Math.min(place.x0 + place.width - 1, span.x1);
    const columns = Int32Array.from({ length: Math.max(0, x1 - x0 + 1) }, (_, n) =>
      index(x0 + n, left, tile.width),
    );
    for (let y = Math.max(place.y0, span.y0); y <= Math.min(place.y0 + place.height - 1, span.y1); y++) {
      const row = index(y, bottom, tile.height) * from.width;
      const to = (y - span.y0) * field.width + x0 - span.x0;
      for (let n = 0; n < columns.length; n++) {
        const at = row + (columns[n] ?? 0);
        field.state[to + n] = from.state[at] ?? STATE.pending;
        field.gap[to + n] = from.gap[at] ?? Number.NaN;
      }
    }
  }
}

/** A plane whose steps are few enough is one grid for all its tiles; a deeper one has a grid for each. */
export const WHOLE_LEVELS = Math.floor(Math.log2(8191 / CELLS));
