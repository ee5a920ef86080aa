import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { circlesOf, landmarksOf, theoremWords, twins } from "./families";

describe("what is known of a family", () => {
  it("has its circles", () => {
    const [one, area, line] = circlesOf(2).map(({ radius }) => radius);
    expect([one, line]).toEqual([1, 0.5]);
    expect(area).toBeCloseTo(Math.SQRT1_2, 14);
  });
  it("claims that all hang together outside only where it is proved: for a prime number of pieces", () => {
    for (const n of [2, 3, 5, 7, 11]) expect(theoremWords(n)[0]).toMatch(/always in one piece/);
    for (const n of [4, 6, 8, 9, 12]) expect(theoremWords(n)[0]).toMatch(/some pieces must meet/);
  });
  it("has landmarks that lie where they are said to", () => {
    const of = (name: string) => landmarksOf(2, 0.5).find((one) => one.name === name)?.s ?? [9, 9];
    expect(Math.hypot(...(of("Twin dragon") as [number, number]))).toBeCloseTo(Math.SQRT1_2, 12);
    expect(Math.hypot(...(of("Tame dragon") as [number, number]))).toBeCloseTo(Math.SQRT1_2, 12);
    expect(landmarksOf(5, 0.381966)).toMatchObject([{ name: "r₅", s: [0.381966, 0] }]);
  });
});

describe("twins", () => {
  const sorted = (points: Uv[]) =>
    points.map(([x, y]) => `${x.toFixed(6)} ${y.toFixed(6)}`.replaceAll("-0.000000", "0.000000")).sort();
  it("are the other corners of a rectangle for M", () => {
    expect(sorted(twins(2, [0.3, 0.4]))).toEqual(
      sorted([
        [0.3, -0.4],
        [-0.3, -0.4],
        [-0.3, 0.4],
      ]),
    );
  });
  it("are fewer on an axis of symmetry", () => {
    expect(sorted(twins(2, [0.5, 0]))).toEqual(sorted([[-0.5, 0]]));
    expect(twins(3, [0.5, 0])).toHaveLength(2);
    expect(twins(3, [0.5, 0.1])).toHaveLength(5);
    expect(twins(3, [0, 0])).toEqual([]);
  });
});
