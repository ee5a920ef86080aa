import { describe, expect, it } from "vitest";
import { climb, dimension, isQuarter, isStraight, mapsOf, samples, spares } from "./rough";

const HEIGHTS = [0, 0.6, 0.2, 0.9, 0.4];
const even = (factor: number) => ({ heights: HEIGHTS, factors: [factor, factor, factor, factor] });

describe("a fractal function", () => {
  it("goes through its points, at every level", () => {
    for (const level of [1, 2, 4]) {
      const found = samples(even(0.6), level);
      expect(found).toHaveLength(4 ** level + 1);
      for (const [i, height] of HEIGHTS.entries())
        expect(found[i * 4 ** (level - 1)]).toBeCloseTo(height, 12);
    }
  });

  it("keeps what it had when it is looked at more closely", () => {
    const [rough, close] = [samples(even(-0.7), 3), samples(even(-0.7), 4)];
    for (const [i, height] of rough.entries()) expect(close[4 * i]).toBeCloseTo(height, 12);
  });

  it("is made of straight lines without roughness", () => {
    const found = samples(even(0), 3);
    expect(found[8]).toBeCloseTo(0.3, 12);
    expect(climb(found)).toBeCloseTo(climb(Float64Array.from(HEIGHTS)), 12);
  });

  it("is carried to its pieces by its maps", () => {
    const [, second] = mapsOf(even(0.3));
    const [a = 0, b, c = 0, d = 0, e = 0, f = 0] = second ?? [];
    expect([a, b, e]).toEqual([0.25, 0, 0.25]);
    expect(d * 0 + f).toBeCloseTo(0.6, 12);
    expect(c + d * 0.4 + f).toBeCloseTo(0.2, 12);
  });
});

describe("its dimension", () => {
  it("is above 1 when the factors sum to more than 1", () => {
    expect(dimension(even(0.25))).toBe(1);
    expect(dimension(even(0.26))).toBeGreaterThan(1);
    expect(dimension(even(0.5))).toBeCloseTo(1.5, 12);
    expect(dimension(even(-0.5))).toBeCloseTo(1.5, 12);
    expect(dimension({ heights: HEIGHTS, factors: [0.9, 0, 0, -0.9] })).toBeCloseTo(
      1 + Math.log(1.8) / Math.log(4),
      12,
    );
  });

  it("is 1 on a straight line, whatever the factors", () => {
    const heights = [0, 0.25, 0.5, 0.75, 1];
    expect(isStraight(heights)).toBe(true);
    expect(isStraight(HEIGHTS)).toBe(false);
    expect(dimension({ heights, factors: [0.9, 0.9, 0.9, 0.9] })).toBe(1);
    expect(climb(samples({ heights, factors: [0.9, 0.9, 0.9, 0.9] }, 5))).toBeCloseTo(1, 9);
  });

  it("is how fast the ups and downs grow", () => {
    for (const factor of [0.4, 0.5, 0.8]) {
      const growth = climb(samples(even(factor), 6)) / climb(samples(even(factor), 5));
      expect(Math.log(growth) / Math.log(4)).toBeCloseTo(dimension(even(factor)) - 1, 1);
    }
    const [near, nearer] = [5, 6].map((level) => climb(samples(even(0.15), level)));
    expect((nearer ?? 0) / (near ?? 1)).toBeLessThan(1.05);
  });
});

it("finds a dimension of 1.25 at a hundredth that the slider has", () => {
  const at = (percent: number) =>
    isQuarter({ heights: [0, 0.7, 0.3], factors: [percent / 100, percent / 100] });
  expect(Array.from({ length: 96 }, (_, percent) => percent).filter(at)).toEqual([59, 60]);
});

it("needs two rough pieces for a dimension above 1.2, and no more", () => {
  const solves = (...factors: number[]) => spares({ heights: HEIGHTS, factors });
  expect(solves(0, 0.7, 0, -0.65)).toBe(true);
  expect(solves(0, 0.65, 0, -0.65)).toBe(false);
  expect(solves(0.7, 0.7, 0.1, 0)).toBe(false);
  expect(solves(0.95, 0, 0, 0)).toBe(false);
});
