import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { placeOf } from "./course";
import { pointAt } from "./orbit";

describe("the curve that s goes along", () => {
  const s: Uv = [-0.3, -0.4];

  it("passes through s, at its place", () => {
    for (const course of ["round", "ray"] as const) {
      const back = pointAt(s, course, placeOf(s, course));
      expect(back[0]).toBeCloseTo(s[0], 12);
      expect(back[1]).toBeCloseTo(s[1], 12);
    }
  });

  it("keeps the size of the copies on the circle, and their turn on the ray", () => {
    for (let k = 0; k <= 20; k++) {
      const place = k / 20;
      expect(Math.hypot(...(pointAt(s, "round", place) as [number, number]))).toBeCloseTo(0.5, 12);
      const [x, y] = pointAt(s, "ray", place);
      expect(x * s[1] - y * s[0]).toBeCloseTo(0, 12);
      // No place along it has no attractor.
      expect(Math.hypot(x, y)).toBeLessThan(1);
    }
  });

  it("tells places from 0 to 1", () => {
    expect(placeOf([0.5, 0], "round")).toBe(0);
    expect(placeOf([0, -0.5], "round")).toBeCloseTo(0.75, 12);
    expect(placeOf([2, 2], "ray")).toBe(1);
  });
});
