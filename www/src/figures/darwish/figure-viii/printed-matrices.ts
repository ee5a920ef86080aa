/** What the scan of Darwish & Abd-El-Wahab shows of the matrices of its Figures vii and viii. */
import type { Point3 } from "#wasm/api";

export type Matrix3 = readonly Point3[];

/** The one matrix that is printed whole, under Figure viii. Of its translation one number is left: 25.59. */
export const FIGURE_VIII: Matrix3 = [
  [0.15, -0.25, -0.07],
  [-0.21, 0.35, 0.19],
  [0.15, -0.14, 0.5],
];

/** Two columns, row by row, of a second matrix under Figure viii. Behind them stand 0.36, and 7.02 of a translation. */
export const SECOND_VIII: readonly (readonly [number, number])[] = [
  [0.18, -0.31],
  [-0.23, 0.42],
  [0.26, -0.3],
];

/** The last row of a second matrix under Figure vii. Behind it stands -1.64, and before it 1.09, of translations. */
export const SECOND_VII: Point3 = [0.05, -0.42, 0.34];

/** Nine numbers under Figure vii. The sixth is cut off after its first decimal, and taken as -0.10. */
export const FIGURE_VII: Matrix3 = [
  [0.39, -0.01, -0.27],
  [-0.27, 0.33, -0.1],
  [-0.04, -0.29, 0.29],
];

/** A turn that brings the second onto the first, to rounding: found by least squares. Others do as well. */
export const TURN = { axis: [0.664, 0.674, 0.279] as Point3, degrees: 160 };

const ROWS: readonly number[] = [0, 1, 2];
const at = (m: Matrix3, i: number, k: number): number => m[i]?.[k] ?? 0;
const made = (entry: (i: number, k: number) => number): Matrix3 =>
  ROWS.map((i): Point3 => [entry(i, 0), entry(i, 1), entry(i, 2)]);
const product = (p: Matrix3, q: Matrix3): Matrix3 =>
  made((i, k) => ROWS.reduce((sum, j) => sum + at(p, i, j) * at(q, j, k), 0));
const transposed = (m: Matrix3): Matrix3 => made((i, k) => at(m, k, i));

/** The matrix of a turn about an axis of any length (Rodrigues). */
function turnAbout({ axis, degrees }: typeof TURN): Matrix3 {
  const length = Math.hypot(...axis);
  const [x, y, z] = axis.map((part) => part / length) as Point3;
  const cross: Matrix3 = [
    [0, -z, y],
    [z, 0, -x],
    [-y, x, 0],
  ];
  const square = product(cross, cross);
  const [sin, cos] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return made((i, k) => (i === k ? 1 : 0) + sin * at(cross, i, k) + (1 - cos) * at(square, i, k));
}

/** A matrix after a turn: conjugated by it (eq 1). */
export function turned(matrix: Matrix3, by: typeof TURN): Matrix3 {
  const turn = turnAbout(by);
  return product(product(turn, matrix), transposed(turn));
}

/**
 * How far two numbers that follow from both figures are apart, at most. With M' = T M T^-1 and u the last row of T^-1,
 * u M' is the last row of M by T^-1: of its three numbers the print of Figure viii gives two.
 */
export function farthestOfSecond(): number {
  const turn = turnAbout(TURN);
  return Math.max(
    ...([0, 1] as const).map((k) => {
      const there = SECOND_VIII.reduce((sum, row, i) => sum + at(turn, i, 2) * row[k], 0);
      const here = SECOND_VII.reduce((sum, x, j) => sum + x * at(turn, k, j), 0);
      return Math.abs(there - here);
    }),
  );
}

/** The largest difference between two numbers in the same place. */
export function farthest(one: Matrix3, other: Matrix3): number {
  return Math.max(...one.flatMap((row, i) => row.map((x, k) => Math.abs(x - at(other, i, k)))));
}
