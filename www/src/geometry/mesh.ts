/** The control mesh of a deformation as numbers: where its points rest, and the same bend by a mesh of another size. */
import { channelsOf, hexOf } from "#style/hex";
import type { Bend, Deformation } from "#wasm/api";

/** What of a bend places its control points. */
export type Mesh = Pick<Bend, "columns" | "rows" | "box" | "moves">;
export type Point = readonly [x: number, y: number];

/** Control points a side. */
export const LEAST_SIDE = 2;
export const MOST_SIDE = 16;

/** Where control point `index` lies while nothing moves it. */
export function rest({ columns, rows, box }: Omit<Mesh, "moves">, index: number): Point {
  const [x0, y0, x1, y1] = box;
  const column = index % columns;
  const row = (index - column) / columns;
  return [x0 + ((x1 - x0) * column) / (columns - 1), y0 + ((y1 - y0) * row) / (rows - 1)];
}

/** Where it lies now. */
export function placed(mesh: Mesh, index: number): Point {
  const [x, y] = rest(mesh, index);
  return [x + (mesh.moves[2 * index] ?? 0), y + (mesh.moves[2 * index + 1] ?? 0)];
}

/** The longer side of the box: what steps of the hand are measured by. */
export function sizeOf([x0, y0, x1, y1]: Mesh["box"]): number {
  return Math.max(x1 - x0, y1 - y0);
}

/** To five figures of a size: far below what is seen, and short in a link. */
export function rounder(size: number): (x: number) => number {
  const digits = Math.min(15, Math.max(0, 5 - Math.floor(Math.log10(size > 0 ? size : 1))));
  return (x) => Number(x.toFixed(digits)) + 0;
}

/** The same bend over another part of the plane: displacements keep their size relative to the mesh. */
export function inBox(deformation: Deformation, box: Deformation["box"]): Deformation {
  const [x0, y0, x1, y1] = deformation.box;
  const [across, up] = [(box[2] - box[0]) / (x1 - x0), (box[3] - box[1]) / (y1 - y0)];
  if (box.every((side, i) => side === deformation.box[i])) return deformation;
  const round = rounder(Math.max(box[2] - box[0], box[3] - box[1]));
  const scaled = (moves: readonly number[]) => moves.map((x, i) => round(x * (i % 2 === 0 ? across : up)));
  const keys = deformation.keys.map(({ at, moves }) => ({ at, moves: scaled(moves) }));
  return { ...deformation, box, keys };
}

/**
 * The same deformation by a mesh of another size. A Bézier mesh of more points bends exactly alike; one of fewer is the
 * nearest in the mean (least squares over the box). The colours of a tint are carried over in the same way.
 */
export function remesh(deformation: Deformation, columns: number, rows: number): Deformation {
  const from = { columns: deformation.columns, rows: deformation.rows };
  const to = { columns: side(columns), rows: side(rows) };
  if (from.columns === to.columns && from.rows === to.rows) return deformation;
  // Far below what is seen, and short in a link.
  const digits = Math.min(15, Math.max(0, 8 - Math.floor(Math.log10(sizeOf(deformation.box)))));
  const round = (x: number) => Number(x.toFixed(digits)) + 0;
  const keys = deformation.keys.map(({ at, moves }) => ({ at, moves: refit(moves, 2, from, to).map(round) }));
  const after: Deformation = { ...deformation, ...to, keys };
  const { tint } = deformation;
  if (!tint) return after;
  const channels = refit(tint.colours.flatMap(channelsOf), 3, from, to);
  const colours = Array.from({ length: to.columns * to.rows }, (_, i) =>
    hexOf(channels.slice(3 * i, 3 * i + 3)),
  );
  return { ...after, tint: { ...tint, colours } };
}

function side(count: number): number {
  return Number.isFinite(count) ? Math.min(MOST_SIDE, Math.max(LEAST_SIDE, Math.round(count))) : LEAST_SIDE;
}

type Sides = Pick<Mesh, "columns" | "rows">;

/**
 * Values of the control points, `width` numbers each, for a mesh of other sides: first along rows, then along columns.
 */
function refit(values: readonly number[], width: number, from: Sides, to: Sides): number[] {
  const wide = new Array<number>(to.columns * from.rows * width).fill(0);
  for (let row = 0; row < from.rows; row++) {
    for (let k = 0; k < width; k++) {
      const line = Array.from(
        { length: from.columns },
        (_, i) => values[(row * from.columns + i) * width + k] ?? 0,
      );
      toCount(line, to.columns).forEach((x, i) => {
        wide[(row * to.columns + i) * width + k] = x;
      });
    }
  }
  const out = new Array<number>(to.columns * to.rows * width).fill(0);
  for (let column = 0; column < to.columns; column++) {
    for (let k = 0; k < width; k++) {
      const line = Array.from(
        { length: from.rows },
        (_, j) => wide[(j * to.columns + column) * width + k] ?? 0,
      );
      toCount(line, to.rows).forEach((x, j) => {
        out[(j * to.columns + column) * width + k] = x;
      });
    }
  }
  return out;
}

/** The Bézier polynomial of other degree, `count - 1`: the same, or the nearest in the mean over [0, 1]. */
export function toCount(coefficients: readonly number[], count: number): number[] {
  let line = coefficients.slice();
  while (line.length < count) line = raised(line);
  while (line.length > count) line = lowered(line);
  return line;
}

/** The same polynomial, one degree higher. */
function raised(p: readonly number[]): number[] {
  const n = p.length;
  return Array.from({ length: n + 1 }, (_, i) => (i * (p[i - 1] ?? 0) + (n - i) * (p[i] ?? 0)) / n);
}

/**
 * The nearest polynomial one degree lower. What is lost is a multiple of the Legendre polynomial, which is orthogonal
 * to all of a lower degree: so taking one degree away after another is as good as all at once.
 */
function lowered(p: readonly number[]): number[] {
  const n = p.length - 1;
  const choose = binomials(n);
  const sign = (i: number) => ((n - i) % 2 === 0 ? 1 : -1);
  // Its leading coefficient, as a multiple of that of the Legendre polynomial, whose coefficients are sign(i)
  // choose(i).
  const lead =
    p.reduce((sum, x, i) => sum + sign(i) * (choose[i] ?? 0) * x, 0) /
    choose.reduce((sum, c) => sum + c * c, 0);
  const rest = p.map((x, i) => x - lead * sign(i) * (choose[i] ?? 0));
  // Backwards through `raised`, from both ends to the middle, where errors have grown least.
  const q = new Array<number>(n).fill(0);
  const half = Math.ceil(n / 2);
  for (let i = 0; i < half; i++) q[i] = (n * (rest[i] ?? 0) - i * (q[i - 1] ?? 0)) / (n - i);
  for (let i = n; i > half; i--) q[i - 1] = (n * (rest[i] ?? 0) - (n - i) * (q[i] ?? 0)) / i;
  return q;
}

function binomials(n: number): number[] {
  const row = [1];
  for (let i = 0; i < n; i++) row.push(((row[i] ?? 0) * (n - i)) / (i + 1));
  return row;
}
