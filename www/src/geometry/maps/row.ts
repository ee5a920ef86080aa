/** Affine maps as rows of numbers, alike in the plane and in space: the rows of the matrix, then the translation. */
import type { MapRow, MapRow3 } from "#wasm/api";

export type Row = MapRow | MapRow3;

/** Of how many axes a row of numbers is. */
export const axesOf = ({ length }: ArrayLike<number>): 2 | 3 => (length === 6 ? 2 : 3);

/** Where in a row its numbers are, as they are printed: a line an axis, the translation last. */
export function linesOf(axes: 2 | 3): readonly (readonly number[])[] {
  const all = Array.from({ length: axes }, (_, k) => k);
  return all.map((line) => [...all.map((k) => axes * line + k), axes * axes + line]);
}

/** What a map of space that leaves the third axis alone is in the plane of the other two. */
export const inPlane = (map: MapRow3): MapRow => [map[0], map[1], map[3], map[4], map[9], map[10]];
