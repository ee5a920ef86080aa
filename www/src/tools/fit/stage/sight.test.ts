import { beforeEach, expect, test, vi } from "vitest";
import type { Curve } from "#wasm/api";
import { FitLine, fineness } from "./sight";

const calls = vi.hoisted(() => ({ polylines: [] as unknown[], freed: 0 }));

vi.mock("#wasm/curve", () => ({
  rough: {
    CurveMorph: class {
      polyline(_s: number, how: unknown) {
        calls.polylines.push(how);
        return new Float64Array(6);
      }
      free() {
        calls.freed++;
      }
    },
  },
}));

const curve = (x: number): Curve => ({
  knots: [
    [x, 0],
    [1, 0],
    [0, 1],
  ],
  edges: [null, null, null],
});
const view = { x: 1, y: 2, scale: 100 };

beforeEach(() => {
  calls.polylines.length = 0;
  calls.freed = 0;
});

test("a line is as fine as half a device pixel, and has no more points than the picture takes", () => {
  expect(fineness(view, { width: 400, height: 600 }, 1)).toEqual({
    tolerance: 0.005,
    most: 8000,
    window: [1 - 2.4, 2 - 3.6, 1 + 2.4, 2 + 3.6],
  });
  expect(fineness(view, { width: 400, height: 600 }, 2)).toMatchObject({ tolerance: 0.0025, most: 16_000 });
  expect(fineness(view, { width: 3000, height: 2000 }, 2).most).toBe(20_000);
  expect(fineness(view, { width: 0, height: 0 }, 1).most).toBe(1000);
});

test("it is drawn anew only where the curve or the view is another", () => {
  const line = new FitLine();
  const size = { width: 400, height: 600 };
  const points = line.of(curve(0), view, size, 1);
  // As a step of progress brings it, with the same numbers.
  expect(line.of(curve(0), { ...view }, size, 1)).toBe(points);
  expect([calls.polylines.length, calls.freed]).toEqual([1, 0]);
  expect(line.of(curve(0), { ...view, scale: 200 }, size, 1)).not.toBe(points);
  expect([calls.polylines.length, calls.freed]).toEqual([2, 0]);
  line.of(curve(0.5), { ...view, scale: 200 }, size, 1);
  expect([calls.polylines.length, calls.freed]).toEqual([3, 1]);
});
