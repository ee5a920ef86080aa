import { describe, expect, it } from "vitest";
import { columnsOf, ringPlace } from "./layout";

describe("a graph", () => {
  it("has its places on a ring, none of them twice", () => {
    const places = Array.from({ length: 5 }, (_, i) =>
      ringPlace(i, 5, 10)
        .map((x) => x.toFixed(6))
        .join(),
    );
    expect(new Set(places).size).toBe(5);
    expect(ringPlace(0, 5, 10)[0]).toBeCloseTo(-10);
  });
  it("goes to the right, step by step", () => {
    const ways = [
      { from: 0, to: 2 },
      { from: 0, to: 1 },
      { from: 1, to: 1 },
      { from: 1, to: 3 },
      { from: 3, to: 0 },
    ];
    expect(columnsOf(4, ways)).toEqual([[0], [1, 2], [3]]);
    expect(columnsOf(1, [{ from: 0, to: 0 }])).toEqual([[0]]);
    expect(columnsOf(0, [])).toEqual([]);
  });
});
