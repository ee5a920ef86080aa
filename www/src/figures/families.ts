/** The systems that the figures are about, written out: nothing here is more than a formula. */
import type { MapRow } from "../engine/api";

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
  const corners = [
    [0, 0],
    [1, 0],
    [0.5, HEIGHT],
  ] as const;
  return corners.map(([x, y]): MapRow => [r, 0, 0, r, (1 - r) * x, (1 - r) * y]);
}

/** The gasket with its first map, the lower left one, turned by half a turn: -x / 2 in place of x / 2. */
export function turnedGasket(): MapRow[] {
  return [[-0.5, 0, 0, -0.5, 0, 0], ...gasket(0.5).slice(1)];
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
