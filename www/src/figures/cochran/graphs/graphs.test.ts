import { describe, expect, it } from "vitest";
import { TABLE_1 as TABLE_1_GRAPH } from "#tools/fit/graph/printed";
import { byPiece, fixedPointImages, rangeOf, stepFor } from "./graphs";
import { TABLE_1 } from "./printed-tables";

describe("the pieces of samples", () => {
  it("share the points where they meet", () => {
    const graph = TABLE_1_GRAPH;
    const pieces = byPiece(graph, new Float64Array([-1, 0, -0.5, 1, 0, 2, 0.5, 3, 1, 4]));
    expect(pieces.map((piece) => [...piece])).toEqual([
      [-1, 0, -0.5, 1, 0, 2],
      [0, 2, 0.5, 3, 1, 4],
    ]);
  });

  it("are empty without samples", () => {
    expect(byPiece(TABLE_1_GRAPH, new Float64Array(0)).map((piece) => piece.length)).toEqual([0, 0]);
  });
});

describe("a scale", () => {
  it("holds all heights, and no less than is asked", () => {
    expect(rangeOf([], { min: -1, max: 1 })).toEqual({ min: -1, max: 1, ticks: [-1, -0.5, 0, 0.5, 1] });
    const wide = rangeOf([[0, -3.2, 1, 9]], { min: -1, max: 1 });
    expect(wide.min).toBeLessThanOrEqual(-3.2);
    expect(wide.max).toBeGreaterThanOrEqual(9);
    expect(wide.ticks.length).toBeGreaterThan(3);
    expect(wide.ticks.length).toBeLessThan(12);
  });

  it("has round steps", () => {
    expect([1, 2, 4, 10, 0.03].map(stepFor)).toEqual([0.2, 0.5, 1, 2, 0.005]);
    expect(stepFor(0)).toBe(1);
  });
});

describe("ideal feature points", () => {
  it("are 2^k + 1 for the function of Table 1, at even steps", () => {
    for (const depth of [0, 3, 6, 7]) {
      const points = fixedPointImages(TABLE_1, depth);
      expect(points).toHaveLength(2 ** depth + 1);
      for (const [i, [t]] of points.entries()) expect(t).toBeCloseTo(-1 + i / 2 ** (depth - 1), 12);
    }
    const [first, last] = [fixedPointImages(TABLE_1, 6)[0], fixedPointImages(TABLE_1, 6).at(-1)];
    expect(first?.[1]).toBeCloseTo(-1, 12);
    expect(last?.[1]).toBeCloseTo(-0.00625, 12);
  });
});
