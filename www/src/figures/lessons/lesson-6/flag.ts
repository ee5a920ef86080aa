/** A letter that shows what a map does to it: which way is up, how large it is, and whether it is mirrored. */
import type { MapRow } from "#wasm/api";
import { apply, type Point } from "../../kit/maps/pieces";

/** The letter F, about the origin, in a box of side 2. */
const F: readonly Point[] = [
  [-0.6, -1],
  [-0.6, 1],
  [0.7, 1],
  [0.7, 0.6],
  [-0.15, 0.6],
  [-0.15, 0.2],
  [0.45, 0.2],
  [0.45, -0.2],
  [-0.15, -0.2],
  [-0.15, -1],
];

/** The outline of the letter under a map, y pointing up, for a path whose y points down. */
export function flagPath(map: MapRow, size: number): string {
  const points = F.map((point) => apply(map, point));
  return `M${points.map(([x, y]) => `${(size * x).toFixed(2)} ${(-size * y).toFixed(2)}`).join("L")}Z`;
}

/** A turn by an angle, with a scale and no shift. */
export function turned(angle: number, scale: number): MapRow {
  const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
  return [c, -s, s, c, 0, 0];
}

/** How large a turn that is blended with no turn number by number gets at least, as a part of what it was: half-way. */
export const leastScale = (angle: number) => Math.abs(Math.cos(angle / 2));

/** Whether a half turn with a stop at an angle, in degrees, never falls below 0.7 of its size. */
export function stopHolds(degrees: number): boolean {
  return [degrees, 180 - degrees].every((turn) => leastScale((turn * Math.PI) / 180) >= 0.7);
}
