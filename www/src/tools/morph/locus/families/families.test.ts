import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { circlesOf, theoremWords, twins } from "./families";
import { landmarkAt, landmarksOf } from "./landmarks";

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
  it("has landmarks that are roots of what is said of them, and a source for each", () => {
    const value = (s: Uv, coefficients: number[]) => {
      let [re, im] = [0, 0];
      for (const c of coefficients.toReversed())
        [re, im] = [re * s[0] - im * s[1] + c, re * s[1] + im * s[0]];
      return Math.hypot(re, im);
    };
    for (const [name, coefficients] of [
      ["Dendrite", [1, -2, 0, 2]],
      ["Slim dendrite", [1, -2, 0, 0, 2]],
      ["Spiral of holes", [1, -2, 2, 0, 0, -2, 0, 0, 2]],
    ] as const) {
      const found = landmarksOf(2, 0.5).find((one) => one.name === name);
      expect(value(found?.s ?? [9, 9], [...coefficients])).toBeLessThan(1e-14);
    }
    for (const { source, s } of landmarksOf(2, 0.5)) {
      expect(source).not.toBe("");
      expect(landmarkAt(landmarksOf(2, 0.5), [s[0] + 1e-12, s[1]])?.s).toEqual(s);
    }
    expect(landmarkAt(landmarksOf(2, 0.5), [0.1, 0.1])).toBeUndefined();
  });
  it("calls a tree what shares one point: one series of 1, 0 and -1 is 0 there", () => {
    for (const name of ["Dendrite", "Slim dendrite"]) {
      const [x, y] = landmarksOf(2, 0.5).find((one) => one.name === name)?.s ?? [9, 9];
      const size = x * x + y * y;
      const most = Math.sqrt(size) / (1 - Math.sqrt(size)) + 1e-6;
      // What is left of the series after so many terms, brought back to the size of the first.
      let left: Uv[] = [[1, 0]];
      for (let n = 0; n < 40; n++) {
        const next: Uv[] = [];
        for (const [p, q] of left) {
          for (const c of [-1, 0, 1]) {
            const rest: Uv = [(p * x + q * y) / size + c, (q * x - p * y) / size];
            if (
              Math.hypot(rest[0], rest[1]) < most &&
              next.every((r) => Math.hypot(r[0] - rest[0], r[1] - rest[1]) > 1e-4)
            )
              next.push(rest);
          }
        }
        left = next;
      }
      expect(left).toHaveLength(1);
    }
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
