import { describe, expect, it } from "vitest";
import { dimension, samples } from "../lesson-18/rough";
import { height, isHalfWay, LEVEL, quarter, SMOOTH, tent } from "./hill";

const hundredths = Array.from({ length: 91 }, (_, i) => i / 100);

describe("the tent with copies on its halves", () => {
  it("is a parabola where each step adds a quarter as much", () => {
    for (const [i, y] of samples(tent(SMOOTH), 9).entries()) {
      const x = i / 2 ** 9;
      expect(y).toBeCloseTo(4 * x * (1 - x), 12);
    }
    expect(height(0.26, 0.3)).not.toBeCloseTo(0.84, 3);
  });

  it("is the sum of ever smaller tents", () => {
    for (const s of [0, 0.3, 0.7])
      for (const [i, y] of samples(tent(s), 8).entries()) expect(height(s, i / 2 ** 8)).toBeCloseTo(y, 9);
  });

  it("goes through its three points, and is as high over a quarter as is said", () => {
    for (const s of hundredths) {
      expect([height(s, 0), height(s, 0.5)].map((y) => Math.round(1e9 * y) / 1e9)).toEqual([0, 1]);
      expect(height(s, 0.25)).toBeCloseTo(quarter(s), 9);
    }
    expect(quarter(LEVEL)).toBe(1);
  });

  it("is more than a line beyond a half, and half-way to an area at one hundredth alone", () => {
    expect(dimension(tent(LEVEL))).toBe(1);
    expect(dimension(tent(0.51))).toBeCloseTo(2 + Math.log2(0.51), 12);
    expect(hundredths.filter(isHalfWay)).toEqual([0.71]);
  });
});
