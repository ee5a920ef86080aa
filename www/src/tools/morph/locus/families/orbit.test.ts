import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { centre, placeOf, pointAt, STEPS } from "./course";

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

  it("winds into a landmark, by the landmark's own factor at every step", () => {
    const to: Uv = [0.5, 0.5];
    centre.value = to;
    const from: Uv = [0.58, 0.46];
    const place = placeOf(from, "spiral");
    const back = pointAt(from, "spiral", place);
    expect(back[0]).toBeCloseTo(from[0], 12);
    expect(back[1]).toBeCloseTo(from[1], 12);
    for (let k = 0; k < STEPS; k++) {
      const [[x, y], next] = [k, k + 1].map((n) => pointAt(from, "spiral", n / STEPS)) as [Uv, Uv];
      // (x + i y - s) s, for s = (1 + i)/2.
      const [dx, dy] = [x - to[0], y - to[1]];
      expect(next[0]).toBeCloseTo(to[0] + (dx - dy) / 2, 12);
      expect(next[1]).toBeCloseTo(to[1] + (dx + dy) / 2, 12);
      expect(Math.hypot(x, y)).toBeLessThan(1);
    }
    // The landmark itself is the end of it.
    expect(placeOf(to, "spiral")).toBe(1);
    expect(pointAt(to, "spiral", 0).every(Number.isFinite)).toBe(true);
  });

  it("tells places from 0 to 1", () => {
    expect(placeOf([0.5, 0], "round")).toBe(0);
    expect(placeOf([0, -0.5], "round")).toBeCloseTo(0.75, 12);
    expect(placeOf([2, 2], "ray")).toBe(1);
  });
});
