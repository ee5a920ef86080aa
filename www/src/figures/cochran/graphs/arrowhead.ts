/**
 * The arrowhead curve: it runs through all of a Sierpinski gasket from corner A to corner C, and with its parameter t
 * as the third coordinate it is the space curve of Cochran, Hart & Flynn, Figure 3.
 */
import type { PlaneGraphPiece } from "#wasm/api";
import type { Point } from "../../kit/maps/pieces";

export interface SpacePoint {
  t: number;
  x: number;
  y: number;
}

/** The corners, where t = 0 begins in A and t = 1 ends in C. */
export const CORNERS: { readonly A: Point; readonly B: Point; readonly C: Point } = {
  A: [0, 0],
  B: [0.5, Math.sqrt(3) / 2],
  C: [1, 0],
};

/** More than this is finer than a screen: 3 to this power pieces. */
export const MOST_DEPTH = 8;

const S = Math.sqrt(3) / 4;
/** Each third of the curve is the whole at half size; the outer two are mirrored too. */
const THIRDS: readonly ((p: Point) => Point)[] = [
  ([x, y]) => [x / 4 + S * y, S * x - y / 4],
  ([x, y]) => [x / 2 + 0.25, y / 2 + S],
  ([x, y]) => [x / 4 - S * y + 0.75, -S * x - y / 4 + S],
];

/** The same with t: the three maps of the space curve as eq 9 has them, a, bx, by, cx, cxy, cyx, cy, d, ex, ey. */
export const PIECES: readonly PlaneGraphPiece["map"][] = THIRDS.map((third, i) => {
  const [[ex, ey], [xx, yx], [xy, yy]] = [third([0, 0]), third([1, 0]), third([0, 1])];
  return [1 / 3, 0, 0, xx - ex, xy - ex, yx - ey, yy - ey, i / 3, ex, ey];
});

/** The 3^depth + 1 points at even steps of t. */
export function arrowhead(depth: number): SpacePoint[] {
  return images([CORNERS.A, CORNERS.C], depth);
}

/**
 * The paper's ideal feature points: the fixed points of the three maps, which are the corners, and their images under
 * all compositions of so many maps; 2 * 3^depth + 1 of them.
 */
export function cornerImages(depth: number): SpacePoint[] {
  return images([CORNERS.A, CORNERS.B, CORNERS.C], depth);
}

function images(begin: Point[], depth: number): SpacePoint[] {
  let points = begin;
  for (let level = 0; level < Math.min(MOST_DEPTH, depth); level++) {
    points = THIRDS.flatMap((third, i) => points.slice(i === 0 ? 0 : 1).map(third));
  }
  return points.map(([x, y], i) => ({ t: i / (points.length - 1), x, y }));
}

/** What the corners count: a height for each makes a function of t of the curve. The paper's are 0, 1/2 and 1. */
export interface Heights {
  A: number;
  B: number;
  C: number;
}

export const TOP: Heights = { A: 0, B: 0.5, C: 1 };

/** t and height of the curve, point by point: t0, x0, t1, x1, .. */
export function heightsAlong(depth: number, heights: Heights): Float64Array {
  return heightsOf(arrowhead(depth), heights);
}

export function heightsOf(points: readonly SpacePoint[], { A, B, C }: Heights): Float64Array {
  const flat = new Float64Array(2 * points.length);
  for (const [i, { t, x, y }] of points.entries()) {
    const b = y / CORNERS.B[1];
    const c = x - b / 2;
    flat[2 * i] = t;
    flat[2 * i + 1] = A * (1 - b - c) + B * b + C * c;
  }
  return flat;
}

export interface Copy {
  /** Whether the copy runs backwards. */
  reflected: boolean;
  /** What heights are multiplied by. */
  c: number;
  /** The copy, point by point, over its third. */
  points: Float64Array;
  /** Root mean square distance from the third, in parts of the height of the whole. */
  rms: number;
}

/** The whole function shrunk into one of its thirds, as near as one map of eq 1 can bring it with its ends tied. */
export function bestCopy(whole: Float64Array, third: number): Copy {
  const count = whole.length / 2 - 1;
  const step = count / 3;
  const first = third * step;
  const x = (i: number) => whole[2 * i + 1] ?? 0;
  const copies = [false, true].map((reflected): Copy => {
    const source = (i: number) => x(reflected ? count - 3 * i : 3 * i);
    const bow = (value: number, from: number, to: number, share: number) =>
      value - from - share * (to - from);
    let [both, own] = [0, 0];
    for (let i = 0; i <= step; i++) {
      const copied = bow(source(i), source(0), source(step), i / step);
      both += copied * bow(x(first + i), x(first), x(first + step), i / step);
      own += copied * copied;
    }
    const c = own > 0 ? both / own : 0;
    const points = new Float64Array(2 * (step + 1));
    let squares = 0;
    for (let i = 0; i <= step; i++) {
      const chord = x(first) + (i / step) * (x(first + step) - x(first));
      const value = chord + c * bow(source(i), source(0), source(step), i / step);
      points[2 * i] = whole[2 * (first + i)] ?? 0;
      points[2 * i + 1] = value;
      squares += (value - x(first + i)) ** 2;
    }
    const tall = heightOf(whole);
    return { reflected, c, points, rms: tall > 0 ? Math.sqrt(squares / (step + 1)) / tall : 0 };
  });
  const [plain, mirrored] = copies as [Copy, Copy];
  return mirrored.rms < plain.rms - 1e-12 ? mirrored : plain;
}

function heightOf(whole: Float64Array): number {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = 1; i < whole.length; i += 2) {
    low = Math.min(low, whole[i] ?? 0);
    high = Math.max(high, whole[i] ?? 0);
  }
  return high - low;
}
