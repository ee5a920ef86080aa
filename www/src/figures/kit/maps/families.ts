/** The systems that the figures are about, written out: nothing here is more than a formula. */
import type { MapRow } from "#wasm/api";

/** The height of a triangle whose sides are 1. */
export const HEIGHT = Math.sqrt(3) / 2;

/** Two maps on a line, each of scale `r`, that keep 0 and 1 in place: {r x, r x + 1 - r}. */
export function dust(r: number): MapRow[] {
  return [
    [r, 0, 0, r, 0, 0],
    [r, 0, 0, r, 1 - r, 0],
  ];
}

/** Three maps of scale `r` towards the corners of a triangle: Sierpinski's gasket at 1/2. */
export function gasket(r: number): MapRow[] {
  return unevenGasket([r, r, r]);
}

const TRIANGLE: readonly (readonly [x: number, y: number])[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];

/** The gasket with its first map, the lower left one, turned by half a turn: -x / 2 in place of x / 2. */
export function turnedGasket(): MapRow[] {
  return [[-0.5, 0, 0, -0.5, 0, 0], ...gasket(0.5).slice(1)];
}

/** The maps that carry the segment from 0 to 1 to each of these chords, without reflection. */
export function chords(
  all: readonly (readonly [from: readonly [number, number], to: readonly [number, number]])[],
): MapRow[] {
  return all.map(([[x, y], [u, v]]): MapRow => {
    const [a, c] = [u - x, v - y];
    return [a, -c, c, a, x, y];
  });
}

/** The height of the peak of Koch's curve over a base of 1. */
export const PEAK = HEIGHT / 3;

/** Koch's curve with its peak cut open: the two middle pieces end `cut` apart. At 0 it is Koch's curve itself. */
export function cutKoch(cut: number): MapRow[] {
  const [left, right] = [(1 - cut) / 2, (1 + cut) / 2];
  const [third, two] = [1 / 3, 2 / 3];
  return chords([
    [
      [0, 0],
      [third, 0],
    ],
    [
      [third, 0],
      [left, PEAK],
    ],
    [
      [right, PEAK],
      [two, 0],
    ],
    [
      [two, 0],
      [1, 0],
    ],
  ]);
}

/** The gasket with a scale of its own for each corner: pieces i and j meet when r_i + r_j is 1. */
export function unevenGasket(scales: readonly [number, number, number]): MapRow[] {
  return scales.map((r, i): MapRow => {
    const [x, y] = TRIANGLE[i] ?? [0, 0];
    return [r, 0, 0, r, (1 - r) * x, (1 - r) * y];
  });
}

/** Every map made smaller about its own fixed point, by `k`: from 1 on down the pieces draw apart. */
export function shrink(maps: readonly MapRow[], k: number): MapRow[] {
  return maps.map((map): MapRow => {
    const [a, b, c, d] = map;
    const [x, y] = fixedPoint(map);
    // p + k (w(q) - p) keeps p.
    const [e, f] = [x - k * (a * x + b * y), y - k * (c * x + d * y)];
    return [k * a, k * b, k * c, k * d, e, f];
  });
}

/** Where a map leaves the plane in place; the origin where there is no such point, or no single one. */
export function fixedPoint([a, b, c, d, e, f]: MapRow): [number, number] {
  const det = (1 - a) * (1 - d) - b * c;
  if (Math.abs(det) < 1e-12) return [0, 0];
  return [((1 - d) * e + b * f) / det, (c * e + (1 - a) * f) / det];
}

export function determinant([a, b, c, d]: MapRow): number {
  return a * d - b * c;
}
