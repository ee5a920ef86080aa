/** Barnsley's fern by its four maps, and what changes of them. */
import type { MapRow } from "#wasm/api";

/** What each map makes, in its order in the gallery. */
export const PARTS = [
  "the stem",
  "all but the lowest pair",
  "a leaf on the left",
  "a leaf on the right",
] as const;

/** The maps that are switched on, each with its place among all: by that it has its colour. */
export function chosen(
  maps: readonly MapRow[],
  on: readonly boolean[],
): { maps: MapRow[]; hues: readonly number[] } {
  const hues = maps.flatMap((_, i) => (on[i] ? [i] : []));
  return { maps: maps.filter((_, i) => on[i]), hues };
}

/** The fern whose large map turns by so many degrees, clockwise, and keeps its scale. */
export function leaning(maps: readonly MapRow[], degrees: number): MapRow[] {
  return maps.map((map, i): MapRow => {
    if (i !== 1) return [...map];
    const [a, b, , , e, f] = map;
    const [scale, angle] = [Math.hypot(a, b), (Math.PI / 180) * degrees];
    const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
    return [c, s, -s, c, e, f];
  });
}

/** By how many degrees the large map turns, clockwise. */
export function lean(maps: readonly MapRow[]): number {
  const [a = 1, b = 0] = maps[1] ?? [];
  return (180 / Math.PI) * Math.atan2(b, a);
}
