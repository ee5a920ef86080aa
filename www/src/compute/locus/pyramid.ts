/** Samples of a plane of parameters at every fineness that was looked at, in tiles. */

import { atAll, atResolution, STATE } from "#geometry/states";
import type { Bounds, Locus } from "#wasm/api";
import type { LocusInputs } from "./job";
import { CELLS, DEEPEST, epsilonOf, type Family, homeOf, levelOf, parameterAt, samplesAt } from "./window";

/** Samples along a side of a tile; of the coarse picture of one, every fourth. */
export const TILE = 64;
export const STEP = 4;
/** Tiles kept, some 20 kB each: twice what the largest map shows at once. */
const MOST_TILES = 2048;
/** So many times as fine, samples are at hand where one has looked nearer: every second of each is one of these. */
const FINER = 2;
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
  /** Parts of it that proofs were looked for, by their number. */
  tried: Set<number>;
}

export interface Samples {
  width: number;
  state: Uint8Array;
  gap: Float32Array;
}

/** A rectangle of the samples of a tile, and its number among those. */
export interface Part extends Span {
  id: TileId;
  n: number;
}

/** Samples over a window, as finely as they are known. */
export interface Field extends Locus {
  /** Of the outermost samples. */
  bounds: Bounds;
  /** The least gap that counts there. */
  epsilon: number;
}

/** A rectangle of samples. */
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
  #base: () => Base | null;
  #previous: Pyramid | null;
  #stands = false;

  /**
   * `base` is the whole plane at level 0, where somebody else keeps it; then there are no tiles of that level. Until
   * `forget` the `previous` plane is what is shown, and all of it: of two planes that are mixed nobody can tell which
   * is where.
   */
  constructor(source: LocusSource, base: (() => Base | null) | null = null, previous: Pyramid | null = null) {
    this.source = source;
    this.#base = base ?? (() => null);
    this.#previous = previous;
    this.based = base !== null;
    if (previous) previous.#stand();
  }

  /** Stays as it is from now on, without what it followed: a long drag would chain them without end. */
  #stand(): void {
    const base = this.#base();
    this.#base = () => base;
    this.#stands = true;
    this.#previous = null;
  }

  /** The plane that is shown, which may be the previous one. */
  get shown(): Pyramid {
    return this.#previous ?? this;
  }

  /** Whether level 0 is kept elsewhere. */
  readonly based: boolean;

  get family(): Family {
    return this.source.family;
  }

  forget(): void {
    this.#previous = null;
  }

  /** The samples that a window needs, ends included. */
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

  /** The places of a window's tiles, the nearest to its middle first. */
  #within(window: Bounds, level: number): TileId[] {
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
    return all.sort((p, q) => p.far - q.far).map(({ id }) => id);
  }

  /** Tiles of a window that are not there yet, the nearest to its middle first. */
  missing(window: Bounds, zoom: number): { coarse: TileId[]; fine: TileId[]; count: number } {
    const level = levelOf(zoom);
    if (level === 0 && this.based) return { coarse: [], fine: [], count: 0 };
    const all = this.#within(window, level);
    // What is looked at is what is kept longest, its middle longest of all.
    for (const id of all.toReversed()) this.#touch(keyOf(id));
    const fine = all.filter((id) => !this.#tiles.get(keyOf(id))?.fine);
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

  /** The bounds of samples `x0` to `x1` and `y0` to `y1` of a level, ends included. */
  boundsOf(level: number, { x0, y0, x1, y1 }: Span): Bounds {
    const { u0, v0, u1, v1 } = homeOf(this.family);
    return {
      u0: parameterAt(u0, u1, level, x0),
      v0: parameterAt(v0, v1, level, y0),
      u1: parameterAt(u0, u1, level, x1),
      v1: parameterAt(v0, v1, level, y1),
    };
  }

  /** Parts of the tiles of a window, so many samples a side, that hold as far as is seen and were not tried in vain. */
  unproved(window: Bounds, zoom: number, side: number): Part[] {
    const found: Part[] = [];
    for (const id of this.#within(window, levelOf(zoom))) {
      const tile = this.#tiles.get(keyOf(id));
      if (!tile?.fine) continue;
      for (let y0 = 0, n = 0; y0 < tile.height; y0 += side) {
        for (let x0 = 0; x0 < tile.width; x0 += side, n++) {
          const [x1, y1] = [Math.min(tile.width, x0 + side), Math.min(tile.height, y0 + side)];
          const part = { id, n, x0, y0, x1, y1 };
          if (!tile.tried.has(n) && this.statesOf(part).includes(STATE.touching)) found.push(part);
        }
      }
    }
    return found;
  }

  /** The states of a part of a tile, row by row. */
  statesOf({ id, x0, y0, x1, y1 }: Part): Uint8Array {
    const found = new Uint8Array((x1 - x0) * (y1 - y0));
    const fine = this.#tiles.get(keyOf(id))?.fine;
    for (let y = y0, k = 0; fine && y < y1; y++, k += x1 - x0)
      found.set(fine.state.subarray(y * fine.width + x0, y * fine.width + x1), k);
    return found;
  }

  /** The same, some of which are proved since. */
  prove({ id, n, x0, y0, x1, y1 }: Part, states: Uint8Array): void {
    const tile = this.#tiles.get(keyOf(id));
    const fine = tile?.fine;
    if (!fine) return;
    tile.tried.add(n);
    for (let y = y0, k = 0; y < y1; y++) {
      for (let x = x0; x < x1; x++, k++) {
        const at = y * fine.width + x;
        if (states[k] === STATE.connected && fine.state[at] === STATE.touching)
          fine.state[at] = STATE.connected;
      }
    }
  }

  put(id: TileId, what: "coarse" | "fine", samples: Samples): void {
    const key = keyOf(id);
    const { width, height } = this.place(id);
    const tile = this.#tiles.get(key) ?? { ...id, width, height, coarse: null, fine: null, tried: new Set() };
    tile[what] = samples;
    this.#tiles.set(key, tile);
    this.#touch(key);
    for (const oldest of this.#tiles.keys()) {
      if (this.#tiles.size <= MOST_TILES) break;
      this.#tiles.delete(oldest);
    }
  }

  /** What was used last stands last: the first of the map is the one to go. */
  #touch(key: string): void {
    const tile = this.#tiles.get(key);
    if (!tile) return;
    this.#tiles.delete(key);
    this.#tiles.set(key, tile);
  }

  /** What is known of a window, at the fineness of its zoom: coarser samples stand in for those that are missing. */
  read(window: Bounds, zoom: number): Field {
    if (this.#previous) return this.#previous.read(window, zoom);
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
        if (!this.#copy(id, span, field)) this.#layBase(id, span, field);
        if (!this.#tiles.get(keyOf(id))?.fine) this.#layFiner(id, span, field);
      }
    }
    return field;
  }

  #layBase(id: TileId, span: Span, field: Field): void {
    const base = this.based && id.level <= FARTHEST ? this.#base() : null;
    if (!base) return;
    // One of which nothing is known is still that of another plane; by itself that plane is shown until there is more.
    if (id.level > 0 && base.progress === 0 && !this.#stands) return;
    const { width, height } = base;
    const whole: Tile = { level: 0, i: 0, j: 0, width, height, coarse: null, fine: base, tried: new Set() };
    this.#lay(id, span, field, whole, 2 ** id.level);
  }

  /** The samples of a place that are known since they are among those of finer tiles. */
  #layFiner({ level, i, j }: TileId, span: Span, field: Field): void {
    for (let k = Math.min(FINER, DEEPEST - level); k > 0; k--) {
      const step = 2 ** k;
      const side = TILE / step;
      for (let down = 0; down < step; down++) {
        for (let across = 0; across < step; across++) {
          const tile = this.#tiles.get(keyOf({ level: level + k, i: i * step + across, j: j * step + down }));
          if (!tile?.fine) continue;
          const { fine } = tile;
          const [left, bottom] = [i * TILE + across * side, j * TILE + down * side];
          for (let y = Math.max(0, span.y0 - bottom); y * step < tile.height; y++) {
            if (y >= side || bottom + y > span.y1) break;
            for (let x = Math.max(0, span.x0 - left); x * step < tile.width; x++) {
              if (x >= side || left + x > span.x1) break;
              const from = y * step * fine.width + x * step;
              const to = (bottom + y - span.y0) * field.width + left + x - span.x0;
              const gap = fine.gap[from] ?? Number.NaN;
              field.state[to] = atResolution(atAll(fine.state[from] ?? STATE.pending), gap, field.epsilon);
              field.gap[to] = gap;
            }
          }
        }
      }
    }
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
