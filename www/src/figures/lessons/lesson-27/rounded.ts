/** Maps with fewer digits, and how far what they make may be from what it was. */
import type { MapRow } from "#wasm/api";
import { norm } from "../../kit/maps/pieces";
import { GOOD, mapOf } from "../lesson-23/collage";

/** The leaf of this lesson: the good collage of “Cover the leaf”. */
export const LEAF: readonly MapRow[] = GOOD.map(mapOf);
/** No point of the leaf is farther from the origin; it is 1 high, and 1.1 wide at most. */
export const REACH = 1.25;

export function rounded(maps: readonly MapRow[], digits: number): MapRow[] {
  return maps.map((map) => map.map((x) => Number(x.toFixed(digits))) as MapRow);
}

/** How far a map moves any point within `REACH` elsewhere than another, at most. */
export function moved(map: MapRow, other: MapRow): number {
  const [a, b, c, d, e, f] = map.map((x, i) => x - (other[i] ?? 0)) as MapRow;
  return norm([a, b, c, d, 0, 0]) * REACH + Math.hypot(e, f);
}

/**
 * How far the shapes of two rows of maps are apart, at most (Hausdorff distance): the farthest that a map and its
 * rounding move a point of the leaf apart, through one minus the factor by which the rounded maps shrink.
 */
export function promise(maps: readonly MapRow[], others: readonly MapRow[]): number {
  const farthest = Math.max(...maps.map((map, i) => moved(map, others[i] ?? map)));
  const shrink = Math.max(...others.map(norm));
  return shrink < 1 ? farthest / (1 - shrink) : Number.POSITIVE_INFINITY;
}

/** So near, in heights of the leaf, nobody tells on a screen. */
export const NEAR = 0.01;
export const MOST_DIGITS = 6;

/** The fewest digits with which the leaf is surely within a distance. */
export function fewestFor(distance: number): number {
  for (let digits = 0; digits <= MOST_DIGITS; digits++)
    if (promise(LEAF, rounded(LEAF, digits)) <= distance) return digits;
  return MOST_DIGITS;
}
