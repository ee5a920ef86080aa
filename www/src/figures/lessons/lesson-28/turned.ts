/** A shape of space, turned or moved by turning or moving its maps: T w T⁻¹ (Darwish and Abd-El-Wahab, eq 1). */
import type { MapRow3 } from "#wasm/api";
import { STANDING } from "../lesson-24/shapes";

/** Round the upright axis, by so many degrees. */
export function turnBy(degrees: number): MapRow3 {
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [cos, -sin, 0, sin, cos, 0, 0, 0, 1, 0, 0, 0];
}

/** As rows of the matrix, then the shift. */
const product = (p: MapRow3, q: MapRow3): MapRow3 => {
  const at = (row: number, column: number) =>
    [0, 1, 2].reduce((sum, k) => sum + (p[3 * row + k] ?? 0) * (q[3 * k + column] ?? 0), 0);
  const shift = (row: number) =>
    [0, 1, 2].reduce((sum, k) => sum + (p[3 * row + k] ?? 0) * (q[9 + k] ?? 0), p[9 + row] ?? 0);
  return [
    ...[0, 1, 2].flatMap((row) => [0, 1, 2].map((column) => at(row, column))),
    ...[0, 1, 2].map(shift),
  ] as unknown as MapRow3;
};

/** A turn is undone by the turn the other way. */
export function turnedMaps(maps: readonly MapRow3[], degrees: number): MapRow3[] {
  const [there, back] = [turnBy(degrees), turnBy(-degrees)];
  return maps.map((map) => product(product(there, map), back));
}

/** The tetrahedron that stands on a face; its first corner is the top. */
export const SHAPE = STANDING;
/** A turn of one third brings the three corners of the foot to one another. */
export const THIRD = 120;

/** Whether the turned maps are the old ones, in whatever order. */
export function isTheSame(maps: readonly MapRow3[], others: readonly MapRow3[]): boolean {
  const near = (p: MapRow3, q: MapRow3) => p.every((x, i) => Math.abs(x - (q[i] ?? 0)) < 1e-9);
  return maps.every((map) => others.some((other) => near(map, other)));
}
