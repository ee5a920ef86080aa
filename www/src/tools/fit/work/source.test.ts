import { expect, test } from "vitest";
import { boxOf, framed, frameOfPoints, frameOfSize } from "./source";

test("whatever its units, what was opened lies in a square of side 2", () => {
  const far = new Float64Array([1e7, 5, 1e7 + 400, 105, 1e7 + 200, 55]);
  expect(boxOf(framed(far, frameOfPoints(far)))).toEqual({ x0: -1, y0: -0.25, x1: 1, y1: 0.25 });
  const picture = new Float64Array([0, 0, 300, 600]);
  expect(boxOf(framed(picture, frameOfSize(300, 600)))).toEqual({ x0: -0.5, y0: -1, x1: 0.5, y1: 1 });
});

test("a point and nothing at all have a frame, too", () => {
  expect(frameOfPoints(new Float64Array([3, 4]))).toEqual({ x: 3, y: 4, scale: 1 });
  expect(frameOfPoints(new Float64Array()).scale).toBe(1);
  expect(frameOfSize(0, 0).scale).toBe(2);
});
