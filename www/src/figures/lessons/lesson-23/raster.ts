/** Sets of the plane as cells of one grid, and how far two of them are apart. */
import type { MapRow } from "#wasm/api";
import type { Point } from "../../kit/maps/pieces";

/** The side of a cell: the leaf is 1 high. */
export const CELL = 0.01;
/** The grid reaches far beyond the leaf, so that copies can stand beside it. */
const [LEFT, BOTTOM] = [-1.25, -0.8];
const SIDE = 250;
const CELLS = SIDE * SIDE;

/** One for each cell that belongs to it, row by row from below. */
export type Raster = Uint8Array;

const middleOf = (at: number): Point => [
  LEFT + ((at % SIDE) + 0.5) * CELL,
  BOTTOM + (Math.floor(at / SIDE) + 0.5) * CELL,
];

function cellOf(x: number, y: number): number | null {
  const [column, row] = [Math.floor((x - LEFT) / CELL), Math.floor((y - BOTTOM) / CELL)];
  return column < 0 || column >= SIDE || row < 0 || row >= SIDE ? null : row * SIDE + column;
}

/** The cells whose middles pass. */
export function rasterOf(test: (point: Point) => boolean): Raster {
  return Uint8Array.from({ length: CELLS }, (_, at) => (test(middleOf(at)) ? 1 : 0));
}

/** The cells that hold a point of these, x0, y0, x1, y1, ..; null where one lies beyond the grid. */
export function rasterOfPoints(points: Float64Array): Raster | null {
  const found = new Uint8Array(CELLS);
  for (let i = 0; i + 1 < points.length; i += 2) {
    const at = cellOf(points[i] ?? 0, points[i + 1] ?? 0);
    if (at === null) return null;
    found[at] = 1;
  }
  return found;
}

/** The images of a set under all maps, together, as far as the grid reaches. The maps can be undone. */
export function imageOf(raster: Raster, maps: readonly MapRow[]): Raster {
  const found = new Uint8Array(CELLS);
  for (const [a, b, c, d, e, f] of maps) {
    const det = a * d - b * c;
    for (let at = 0; at < CELLS; at++) {
      if (found[at] === 1) continue;
      const [u, v] = middleOf(at);
      const [x, y] = [u - e, v - f];
      const back = cellOf((d * x - b * y) / det, (a * y - c * x) / det);
      if (back !== null && raster[back] === 1) found[at] = 1;
    }
  }
  return found;
}

/** A distance, and two points that are so far apart. */
export interface Worst {
  distance: number;
  from: Point;
  to: Point;
}

/**
 * The Hausdorff distance of two sets: the farthest that a point of one is from the nearest of the other. Right to two
 * cells for what the cells stand for; null where one of them has no point.
 */
export function hausdorff(one: Raster, other: Raster): Worst | null {
  const [there, back] = [farthest(one, other), farthest(other, one)];
  if (!there || !back) return null;
  return there.distance >= back.distance ? there : back;
}

/** The point of a set that is farthest from another set, and the nearest one there. */
function farthest(of: Raster, from: Raster): Worst | null {
  const squares = squaredDistances(from);
  let [worst, at] = [-1, -1];
  for (let i = 0; i < CELLS; i++) {
    const square = of[i] === 1 ? (squares[i] ?? 0) : -1;
    if (square > worst) [worst, at] = [square, i];
  }
  if (at < 0 || !Number.isFinite(worst)) return null;
  return { distance: CELL * Math.sqrt(worst), from: middleOf(at), to: middleOf(nearestTo(at, from)) };
}

function nearestTo(at: number, set: Raster): number {
  const [column, row] = [at % SIDE, Math.floor(at / SIDE)];
  let [best, found] = [Number.POSITIVE_INFINITY, at];
  for (let i = 0; i < CELLS; i++) {
    if (set[i] !== 1) continue;
    const square = ((i % SIDE) - column) ** 2 + (Math.floor(i / SIDE) - row) ** 2;
    if (square < best) [best, found] = [square, i];
  }
  return found;
}

/** Squares of the distances to the nearest cell of a set, in cells: rows first, then columns. */
function squaredDistances(set: Raster): Float64Array {
  const squares = Float64Array.from(set, (held) => (held === 1 ? 0 : Number.POSITIVE_INFINITY));
  for (let k = 0; k < SIDE; k++) alongLine(squares, k * SIDE, 1);
  for (let k = 0; k < SIDE; k++) alongLine(squares, k, SIDE);
  return squares;
}

/** What one line needs, made once. */
const heights = new Float64Array(SIDE);
const feet = new Int32Array(SIDE);
const begins = new Float64Array(SIDE);

/**
 * Felzenszwalb and Huttenlocher, Distance transforms of sampled functions (2012): the least of (q - p)^2 + f(p) over p
 * for each q of a line, as the lower envelope of parabolas.
 */
function alongLine(values: Float64Array, start: number, step: number): void {
  let last = -1;
  for (let q = 0; q < SIDE; q++) {
    const height = values[start + q * step] ?? 0;
    heights[q] = height;
    if (height === Number.POSITIVE_INFINITY) continue;
    let meets = Number.NEGATIVE_INFINITY;
    while (last >= 0) {
      const p = feet[last] ?? 0;
      meets = (height + q * q - (heights[p] ?? 0) - p * p) / (2 * (q - p));
      if (meets > (begins[last] ?? 0)) break;
      last--;
      meets = Number.NEGATIVE_INFINITY;
    }
    last++;
    feet[last] = q;
    begins[last] = meets;
  }
  if (last < 0) return;
  let k = 0;
  for (let q = 0; q < SIDE; q++) {
    while (k < last && (begins[k + 1] ?? 0) < q) k++;
    const p = feet[k] ?? 0;
    values[start + q * step] = (q - p) ** 2 + (heights[p] ?? 0);
  }
}
