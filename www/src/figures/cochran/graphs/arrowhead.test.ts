import { describe, expect, it } from "vitest";
import known from "../../../../../tests/known/fit/hidden_variable.json";
import {
  arrowhead,
  bestCopy,
  CORNERS,
  cornerImages,
  heightsAlong,
  heightsOf,
  PIECES,
  TOP,
} from "./arrowhead";

describe("the arrowhead curve", () => {
  it("runs from A to C in equal steps, each half as long a level", () => {
    for (const depth of [0, 1, 4]) {
      const points = arrowhead(depth);
      expect(points).toHaveLength(3 ** depth + 1);
      expect(points[0]).toEqual({ t: 0, x: 0, y: 0 });
      expect(points.at(-1)?.t).toBe(1);
      expect(Math.hypot((points.at(-1)?.x ?? 0) - 1, points.at(-1)?.y ?? 1)).toBeLessThan(1e-12);
      for (const [i, p] of points.entries()) {
        const q = points[i + 1];
        if (q) expect(Math.hypot(q.x - p.x, q.y - p.y)).toBeCloseTo(2 ** -depth, 12);
        expect(p.y).toBeGreaterThan(-1e-12);
        expect(p.y).toBeLessThan(CORNERS.B[1] + 1e-12);
      }
    }
  });

  it("is made of three pieces, each the whole by a map of eq 9", () => {
    const [whole, finer] = [arrowhead(3), arrowhead(4)];
    for (const [i, [a, bx, by, cx, cxy, cyx, cy, d, ex, ey]] of PIECES.entries())
      for (const [k, { t, x, y }] of whole.entries()) {
        const there = finer[27 * i + k];
        expect(a * t + d).toBeCloseTo(there?.t ?? Number.NaN, 12);
        expect(bx * t + cx * x + cxy * y + ex).toBeCloseTo(there?.x ?? Number.NaN, 12);
        expect(by * t + cyx * x + cy * y + ey).toBeCloseTo(there?.y ?? Number.NaN, 12);
      }
  });

  it("has the heights of the hidden-variable function", () => {
    const heights = heightsAlong(5, TOP);
    expect(heights).toHaveLength(2 * known.curve.t.length);
    for (const [i, t] of known.curve.t.entries()) {
      expect(heights[2 * i]).toBeCloseTo(t, 12);
      expect(heights[2 * i + 1]).toBeCloseTo(known.curve.x[i] ?? Number.NaN, 8);
    }
  });

  it("has the feature points that the votes are cast with", () => {
    for (const [name, depth] of [
      ["features55", 3],
      ["features163", 4],
    ] as const) {
      const flat = heightsOf(cornerImages(depth), TOP);
      expect(flat).toHaveLength(2 * known[name].t.length);
      for (const [i, t] of known[name].t.entries()) {
        expect(flat[2 * i]).toBeCloseTo(t, 12);
        expect(flat[2 * i + 1]).toBeCloseTo(known[name].x[i] ?? Number.NaN, 8);
      }
    }
  });

  it("takes heights for its corners", () => {
    const flat = heightsAlong(3, { A: 2, B: 2, C: 2 });
    for (let i = 1; i < flat.length; i += 2) expect(flat[i]).toBeCloseTo(2, 12);
  });
});

describe("a copy of the whole", () => {
  it("is the middle third exactly, and none of the others", () => {
    const whole = heightsAlong(6, TOP);
    const middle = bestCopy(whole, 1);
    expect(middle.rms).toBeLessThan(1e-12);
    expect(middle.c).toBeCloseTo(0.5, 12);
    expect(middle.reflected).toBe(false);
    for (const third of [0, 2]) expect(bestCopy(whole, third).rms).toBeGreaterThan(0.01);
  });

  it("may run backwards", () => {
    const x = [0, 0, 0, 1, 3, 2, 4, 1, 0, 2];
    // From the other end: 2, 4, 1, 0 over t = 1, 2/3, 1/3, 0, its chord from 2 to 0, half as rough.
    x[1] = 1 / 3 + 0.5 * (4 - 4 / 3);
    x[2] = 2 / 3 + 0.5 * (1 - 2 / 3);
    const copy = bestCopy(Float64Array.from(x.flatMap((value, i) => [i / 9, value])), 0);
    expect(copy.reflected).toBe(true);
    expect(copy.c).toBeCloseTo(0.5, 12);
    expect(copy.rms).toBeLessThan(1e-12);
  });

  it("copes with a flat function", () => {
    expect(bestCopy(heightsAlong(2, { A: 1, B: 1, C: 1 }), 0)).toMatchObject({ c: 0, rms: 0 });
  });
});
