import { describe, expect, it } from "vitest";
import {
  aired,
  type Frame,
  heights,
  leftOf,
  rounded,
  startIn,
  tAt,
  ticks,
  tickText,
  topOf,
  xAt,
} from "./frame";

const frame: Frame = { t: [10, 20], x: [-1, 3], left: 50, top: 10, width: 500, height: 200 };

it("goes to the stage and back", () => {
  expect(leftOf(frame, 15)).toBe(300);
  expect(topOf(frame, 3)).toBe(10);
  expect(topOf(frame, -1)).toBe(210);
  expect(tAt(frame, leftOf(frame, 12.5))).toBeCloseTo(12.5, 12);
  expect(xAt(frame, topOf(frame, 0.3))).toBeCloseTo(0.3, 12);
});

it("rounds no coarser than half a pixel", () => {
  for (const perPixel of [0.002, 0.3, 7, 1e-9]) {
    const value = 12.345678901234;
    expect(Math.abs(rounded(value, perPixel) - value)).toBeLessThanOrEqual(perPixel / 2);
  }
  expect(rounded(1.23456, 0.01)).toBe(1.235);
});

describe("ticks", () => {
  it("are round, within, and not more than asked for", () => {
    expect(ticks([0, 1], 5).values).toEqual([0, 0.2, 0.4, 0.6, 0.8, 1]);
    expect(ticks([-1.1, 1.05], 5).values).toEqual([-1, -0.5, 0, 0.5, 1]);
    expect(ticks([2000, 2024], 6).values).toEqual([2000, 2005, 2010, 2015, 2020]);
    expect(ticks([3, 3], 5).values).toEqual([]);
    expect(ticks([Number.NaN, 1], 5).values).toEqual([]);
  });

  it("tell neighbours apart however deep it is zoomed", () => {
    const deep = ticks([0.123456, 0.123458], 4);
    expect(new Set(deep.values.map((value) => tickText(value, deep))).size).toBe(deep.values.length);
    expect(tickText(-0.0, ticks([-1, 1], 4))).toBe("0.0");
    expect(tickText(-0.5, ticks([-1, 1], 4))).toBe("−0.5");
    const far = ticks([7_000_000, 7_000_020], 4);
    expect(far.values.map((value) => tickText(value, far))).toContain("7000010");
    const large = ticks([0, 3e9], 4);
    expect(large.values.map((value) => tickText(value, large))).toEqual(["0", "1×10⁹", "2×10⁹", "3×10⁹"]);
  });
});

it("finds points and heights in a stretch", () => {
  const points = [0, 5, 1, -2, 2, 7, 3, 0];
  expect(startIn(points, 0.5)).toBe(2);
  expect(startIn(points, 9)).toBe(8);
  expect(heights(points, [0.5, 2.5])).toEqual([-2, 7]);
  expect(heights(points, [4, 5])).toBeNull();
  expect(aired([0, 1])[0]).toBeLessThan(0);
  expect(aired([2, 2])[1]).toBeGreaterThan(2);
});
