import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { orbitOf, type Point } from "./orbit";
import { type Board, cellOf, fewest, hullOf, isIn, middleOf, newTarget, unplayable } from "./target";

const HEIGHT = Math.sqrt(3) / 2;
const MAPS: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, HEIGHT / 2],
];
const BOARD: Board = { maps: MAPS, hull: hullOf(MAPS), start: [0.5, HEIGHT / 3] };
const last = (letters: readonly number[]) => orbitOf(MAPS, BOARD.start, letters).at(-1) as Point;

describe("a cell to reach", () => {
  it("lies in the polygon around the shape, which of a triangle is the triangle", () => {
    expect(BOARD.hull).toHaveLength(3);
    const [x, y] = middleOf(cellOf(BOARD, [1]));
    expect(x).toBeCloseTo(0.75, 6);
    expect(y).toBeCloseTo(HEIGHT / 6, 6);
  });

  it("is reached by its letters from the last to the first, and by no fewer", () => {
    for (const address of [[1], [0, 2], [2, 1, 0], [1, 1, 2, 0], [0, 1, 2, 2, 1]]) {
      const way = fewest(BOARD, address);
      expect(way).toEqual([...address].reverse());
      expect(isIn(BOARD, address, last(way))).toBe(true);
      expect(isIn(BOARD, address, last(way.slice(1)))).toBe(false);
    }
    expect(isIn(BOARD, [1, 0], last([1, 0]))).toBe(false);
  });

  it("takes fewer throws from a point that lies well already", () => {
    const board = { ...BOARD, start: [0.05, 0.05] as Point };
    expect(fewest(board, [2, 0])).toEqual([2]);
    expect(fewest(board, [0])).toEqual([]);
  });

  it("is the same for the same seed, and never where the start is", () => {
    for (let seed = 0; seed < 40; seed++) {
      const target = newTarget(BOARD, 3, seed);
      expect(target).toEqual(newTarget(BOARD, 3, seed));
      expect(target).toHaveLength(3);
      const inside = { ...BOARD, start: [0.05, 0.05] as Point };
      expect(isIn(inside, newTarget(inside, 1, seed), inside.start)).toBe(false);
    }
    expect(
      new Set(Array.from({ length: 40 }, (_, seed) => newTarget(BOARD, 3, seed).join())).size,
    ).toBeGreaterThan(15);
  });

  it("is not offered where there is none", () => {
    expect(unplayable(MAPS)).toBeNull();
    expect(unplayable(MAPS.slice(0, 1))).toContain("two maps");
    expect(unplayable(Array.from({ length: 255 }, () => MAPS[0] as MapRow))).toContain("255 maps");
    expect(unplayable([...MAPS, [0, 0, 0, 0.16, 0, 0]])).toContain("Map 4");
    expect(isIn({ maps: MAPS, hull: [], start: [0, 0] }, [0], [0, 0])).toBe(false);
  });
});
