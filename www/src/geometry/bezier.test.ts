import { describe, expect, it } from "vitest";
import { bentAt, bernstein, gridLines, placeAt, restAt, weightsAt } from "./bezier";
import type { Mesh, Point } from "./mesh";

const BENT: Mesh = {
  columns: 5,
  rows: 3,
  box: [0, 0, 2, 1],
  moves: Array.from({ length: 30 }, (_, i) => 0.1 * Math.sin(7 * i)),
};

describe("the blend", () => {
  it("has weights that sum to one", () => {
    for (const t of [0, 0.3, 1, -0.4]) {
      expect(bernstein(t, 16).reduce((a, b) => a + b)).toBeCloseTo(1, 8);
      expect(weightsAt({ columns: 5, rows: 2 }, t, 0.7).reduce((a, b) => a + b)).toBeCloseTo(1, 10);
    }
    expect(bernstein(0.5, 1)).toEqual([1]);
    expect(bernstein(0.5, 4)).toEqual([0.125, 0.375, 0.375, 0.125]);
  });
});

describe("gridLines", () => {
  it("goes through where the mesh takes each crossing, and heads along", () => {
    const lines = gridLines(BENT, 11);
    expect(lines).toHaveLength(22);
    const near = ([px, py]: Point | readonly [], [qx, qy]: Point) => {
      expect(px).toBeCloseTo(qx, 12);
      expect(py).toBeCloseTo(qy, 12);
    };
    near(lines[3]?.points[7] ?? [], bentAt(BENT, 0.3, 0.7));
    near(lines[11 + 7]?.points[3] ?? [], bentAt(BENT, 0.3, 0.7));
    // A step of a tenth, by a difference over a slight one.
    const [ax, ay] = bentAt(BENT, 0.3, 0.7 - 1e-6);
    const [bx, by] = bentAt(BENT, 0.3, 0.7 + 1e-6);
    const [hx, hy] = lines[3]?.headings[7] ?? [0, 0];
    expect(hx).toBeCloseTo((bx - ax) / 2e-5, 5);
    expect(hy).toBeCloseTo((by - ay) / 2e-5, 5);
  });
});

describe("placeAt", () => {
  it("finds the place that was taken there", () => {
    for (const [u, v] of [
      [0.2, 0.9],
      [0, 0],
      [1, 0.5],
      [1.2, -0.1],
    ] as const) {
      const [p, q] = placeAt(BENT, bentAt(BENT, u, v));
      expect(p).toBeCloseTo(u, 6);
      expect(q).toBeCloseTo(v, 6);
    }
  });

  it("stays near the box, whatever is asked, folded or flat", () => {
    const flat: Mesh = { columns: 2, rows: 2, box: [0, 0, 1, 1], moves: [0, 0, -1, 0, 0, -1, -1, -1] };
    const folded: Mesh = { columns: 2, rows: 2, box: [0, 0, 1, 1], moves: [2, 0, -2, 0, 0, 0, 0, 0] };
    for (const mesh of [BENT, flat, folded]) {
      for (const point of [
        [0.3, 0.3],
        [1e9, -1e9],
      ] as const) {
        for (const t of placeAt(mesh, point)) {
          expect(Number.isFinite(t)).toBe(true);
          expect(Math.abs(t - 0.5)).toBeLessThanOrEqual(1);
        }
      }
    }
    const place = placeAt(folded, [0.4, 0.6]);
    const [x, y] = bentAt(folded, ...place);
    expect(Math.hypot(x - 0.4, y - 0.6)).toBeLessThan(1e-6);
    expect(restAt(folded, 0.5, 0.25)).toEqual([0.5, 0.25]);
  });
});
