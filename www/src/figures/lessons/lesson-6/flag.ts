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
