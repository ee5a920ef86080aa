import { expect, it } from "vitest";
import { SEEDS, seedCorners } from "./seed";

const area = (corners: readonly (readonly [number, number])[]) =>
  corners.reduce((sum, [x, y], i) => {
    const [p, q] = corners[(i + 1) % corners.length] ?? [x, y];
    return sum + (x * q - p * y) / 2;
  }, 0);

it("are as large as the attractor, turn one way, and are seen where it is flat", () => {
  const hull = [
    [0, 0],
    [2, 0],
    [0, 1],
  ] as const;
  for (const { value } of SEEDS) {
    const corners = seedCorners(value, { x0: 0, y0: 0, x1: 2, y1: 1 }, hull);
    if (value === "point") expect(corners).toEqual([[1, 0.5]]);
    else expect(area(corners), value).toBeGreaterThan(0.5);
    for (const [x, y] of corners) {
      expect(Math.abs(x - 1), value).toBeLessThanOrEqual(1);
      expect(Math.abs(y - 0.5), value).toBeLessThanOrEqual(1);
    }
  }
  expect(area(seedCorners("hull", { x0: 0, y0: 0, x1: 2, y1: 1 }, hull))).toBe(1);
  expect(area(seedCorners("square", { x0: 3, y0: 3, x1: 3, y1: 3 }, []))).toBe(1);
  // Of a line the rectangle is drawn, whose edge is seen.
  const line = { x0: 0, y0: 0, x1: 2, y1: 0 };
  expect(seedCorners("hull", line, hull)).toEqual(seedCorners("frame", line, hull));
});
