import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { dust, gasket } from "./families";
import { compose, distances, norm, spanningTree } from "./pieces";

describe("distances between pieces", () => {
  it("knows the gap of the dust and of the gasket", () => {
    for (const r of [0.25, 0.4, 0.47]) {
      const [only] = distances(dust(r), 1e-5);
      expect(only?.upper).toBeCloseTo(1 - 2 * r, 4);
      expect(only?.lower).toBeLessThanOrEqual(1 - 2 * r + 1e-12);
      expect(only?.upper).toBeGreaterThanOrEqual(1 - 2 * r - 1e-12);
      for (const pair of distances(gasket(r), 1e-5)) expect(pair.upper).toBeCloseTo(1 - 2 * r, 4);
    }
  });

  it("finds nothing between pieces that touch", () => {
    for (const pair of distances(gasket(0.5))) {
      expect(pair.lower).toBe(0);
      expect(pair.upper).toBeLessThan(1e-3);
    }
  });

  it("joins by the cheapest tree, whose widest edge is not the least distance", () => {
    const maps: MapRow[] = [
      [0.2, 0, 0, 0.2, 0, 0],
      [0.2, 0, 0, 0.2, 0.3, 0],
      [0.2, 0, 0, 0.2, 0.8, 0],
    ];
    const all = distances(maps);
    const { edges, widest } = spanningTree(3, all);
    expect(edges.map((edge) => edge.between)).toEqual([
      [0, 1],
      [1, 2],
    ]);
    expect(widest?.between).toEqual([1, 2]);
    expect(all.find(({ between: [i, j] }) => i === 0 && j === 2)?.upper).toBeGreaterThan(widest?.upper ?? 9);
  });

  it("has no tree for one piece, and does not run on with maps that do not shrink", () => {
    expect(spanningTree(1, [])).toEqual({ edges: [], widest: null });
    const [pair] = distances([
      [1, 0, 0, 1, 1, 0],
      [0.5, 0, 0, 0.5, 0, 0],
    ]);
    expect(pair?.lower).toBe(0);
  });
});

it("composes and measures maps", () => {
  const half: MapRow = [0.5, 1, 2, 0.5, 1, 0];
  expect(compose(half, half)).toEqual([2.25, 1, 2, 2.25, 1.5, 2]);
  expect(norm([3, 0, 0, 4, 0, 0])).toBeCloseTo(4, 12);
  expect(norm([1, 1, 0, 1, 0, 0])).toBeCloseTo((1 + Math.sqrt(5)) / 2, 12);
  expect(norm([0, 0, 0, 0, 5, 5])).toBe(0);
});
