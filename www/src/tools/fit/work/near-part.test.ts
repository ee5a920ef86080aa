import { expect, test } from "vitest";
import type { Component, Masked } from "#workers/fit/trace-types";
import { nearPart } from "./near-part";

type Box = Component["box"];

const WIDTH = 200;
const HEIGHT = 160;

/** Rectangles, the largest first. */
function maskOf(...boxes: Box[]): Masked {
  const mask = new Uint8Array(WIDTH * HEIGHT);
  for (const [x0, y0, x1, y1] of boxes) {
    for (let y = y0; y < y1; y++) mask.fill(255, y * WIDTH + x0, y * WIDTH + x1);
  }
  const components = boxes.map((box): Component => {
    const [x0, y0, x1, y1] = box;
    return { area: (x1 - x0) * (y1 - y0), box, at: [x0, y0], touchesBorder: false };
  });
  return { width: WIDTH, height: HEIGHT, mask, threshold: 0, channel: "light", components, warnings: [] };
}

/** The way round a rectangle, a point a pixel. */
function around([x0, y0, x1, y1]: Box): number[] {
  const points: number[] = [];
  for (let x = x0; x < x1; x++) points.push(x, y0);
  for (let y = y0; y < y1; y++) points.push(x1, y);
  for (let x = x1; x > x0; x--) points.push(x, y1);
  for (let y = y1; y > y0; y--) points.push(x0, y);
  return points;
}

const LEAF: Box = [20, 20, 120, 140];
const near = (...others: Box[]) => nearPart(maskOf(LEAF, ...others), 0, around(LEAF));

test("a lobe across a narrow gap is named with its share, and the stroke covers the gap along the lobe", () => {
  const found = near([124, 40, 148, 100]);
  expect(found?.index).toBe(1);
  expect(found?.share).toBeCloseTo((24 * 60) / (100 * 120));
  const { points = [], radius = 0, what, exact } = found?.stroke ?? {};
  expect([what, exact]).toEqual(["keep", true]);
  for (let y = 42; y < 98; y++) {
    for (const x of [120.5, 122, 123.5]) {
      expect(distance(points, x, y), `${x}, ${y}`).toBeLessThanOrEqual(radius);
    }
  }
  // It stays where the gap is.
  const ys = points.filter((_, i) => i % 2 === 1);
  expect(Math.min(...ys)).toBeGreaterThan(30);
  expect(Math.max(...ys)).toBeLessThan(110);
});

test("what is far away, small, larger than what is fitted, or within its outline is not spoken of", () => {
  expect(near([150, 40, 174, 100])).toBeNull();
  expect(near([124, 40, 130, 46])).toBeNull();
  expect(near([40, 40, 70, 70])).toBeNull();
  expect(nearPart(maskOf(LEAF, [124, 40, 148, 100]), 1, around([124, 40, 148, 100]))).toBeNull();
  expect(near()).toBeNull();
});

test("of two the larger is named, wherever the first of the list lies", () => {
  expect(near([160, 20, 198, 80], [124, 40, 148, 100], [60, 143, 90, 158])?.index).toBe(2);
});

function distance(points: readonly number[], x: number, y: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 3 < points.length; i += 2) {
    const [ax, ay, bx, by] = points.slice(i, i + 4) as [number, number, number, number];
    const length = (bx - ax) ** 2 + (by - ay) ** 2;
    const t =
      length > 0 ? Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length)) : 0;
    least = Math.min(least, Math.hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y));
  }
  return least;
}
