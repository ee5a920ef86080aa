/** A figure under all words of so many maps: what Hutchinson's operator makes of it, step by step. */
import type { MapRow } from "#wasm/api";
import { compose, type Point } from "./pieces";

/** One copy: the map that makes it, and the first letter of its word. */
export interface Copy {
  map: MapRow;
  /** Null for the figure itself. */
  first: number | null;
}

/** Copies that are drawn at once, at most. */
export const MOST_COPIES = 20_000;

const STILL: MapRow = [1, 0, 0, 1, 0, 0];

/** The copies after so many steps; after fewer where there would be too many. */
export function copies(maps: readonly MapRow[], steps: number): Copy[] {
  let all: Copy[] = [{ map: STILL, first: null }];
  for (let step = 0; step < Math.min(steps, mostSteps(maps.length)); step++) {
    // The new letter is the first: the last figure is put under each map.
    all = maps.flatMap((map, i) => all.map((copy) => ({ map: compose(map, copy.map), first: i })));
  }
  return all;
}

/** The steps after which so many maps make no more copies than can be drawn. */
export function mostSteps(maps: number): number {
  return maps < 2 ? 64 : Math.floor(Math.log(MOST_COPIES) / Math.log(maps) + 1e-9);
}

/** Figures to start from, in a box of side 1. */
export const STARTS: Readonly<Record<"square" | "letter" | "dot", readonly (readonly Point[])[]>> = {
  square: [
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ],
  ],
  letter: [
    [
      [0.2, 0],
      [0.2, 1],
      [0.85, 1],
      [0.85, 0.8],
      [0.42, 0.8],
      [0.42, 0.6],
      [0.72, 0.6],
      [0.72, 0.4],
      [0.42, 0.4],
      [0.42, 0],
    ],
  ],
  dot: [
    Array.from({ length: 16 }, (_, i): Point => {
      const angle = (2 * Math.PI * i) / 16;
      return [0.8 + 0.06 * Math.cos(angle), 0.75 + 0.06 * Math.sin(angle)];
    }),
  ],
};
