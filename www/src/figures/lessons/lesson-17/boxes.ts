/** Boxes that hold a part of a shape, and the dimension that Moran's equation gives. */
import type { MapRow } from "#wasm/api";
import { copies } from "../../kit/maps/iterates";
import { apply } from "../../kit/maps/pieces";

/** A shape in the square from 0 to 1 whose pieces lie in a grid: each step of it divides a side by `base`. */
export interface Gridded {
  maps: MapRow[];
  /** Two or three. */
  base: number;
  /** The finest grid that is counted: `base` to this power boxes a side. */
  most: number;
}

/** The copies of the whole, scaled by 1/base, that stand in these boxes of the first grid. */
function gridded(
  base: number,
  most: number,
  boxes: readonly (readonly [column: number, row: number])[],
): Gridded {
  return { base, most, maps: boxes.map(([x, y]): MapRow => [1 / base, 0, 0, 1 / base, x / base, y / base]) };
}

const ALL = [0, 1, 2].flatMap((x) => [0, 1, 2].map((y) => [x, y] as const));

export const GRIDDED = {
  // From corner to corner: along an edge it would lie between two rows of boxes.
  line: gridded(2, 6, [
    [0, 0],
    [1, 1],
  ]),
  square: gridded(2, 5, [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ]),
  gasket: gridded(2, 6, [
    [0, 0],
    [1, 0],
    [0, 1],
  ]),
  carpet: gridded(
    3,
    3,
    ALL.filter(([x, y]) => x !== 1 || y !== 1),
  ),
} as const satisfies Record<string, Gridded>;

/**
 * The boxes of a grid with base^level boxes a side that hold more of the shape than a part of their edge, as column and
 * row from the lower left. A piece of that level fills one box, which is told by the middle of the piece's square.
 */
export function boxesOf({ maps, base, most }: Gridded, level: number): [column: number, row: number][] {
  const n = Math.max(0, Math.min(most, Math.round(level)));
  const side = base ** n;
  const found = new Set<number>();
  for (const { map } of copies(maps, n)) {
    const [x, y] = apply(map, [0.5, 0.5]);
    found.add(Math.floor(x * side) + side * Math.floor(y * side));
  }
  return [...found].map((at) => [at % side, Math.floor(at / side)]);
}

/** The D for which the scales to the power of D sum to 1 (Moran 1946); they are above 0 and below 1, at least two. */
export function moran(scales: readonly number[]): number {
  const sum = (d: number) => scales.reduce((all, r) => all + r ** d, 0);
  let [low, high] = [0, 1];
  while (sum(high) > 1 && high < 1e6) high *= 2;
  for (let i = 0; i < 80; i++) {
    const middle = (low + high) / 2;
    if (sum(middle) > 1) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** The gasket once more, with a map too many, which is map 2 and then map 1: its piece is a part of piece 1. */
export const REPEATED: readonly MapRow[] = [...GRIDDED.gasket.maps, [0.25, 0, 0, 0.25, 0.25, 0]];
