import { expect, it } from "vitest";
import { distanceTo, edgePath, edgeStarts } from "./edges";

const points = [0, 0, 1, 1, 2, 0, 2, 2, 0, 2, -1, 1];
const knots = [
  [0, 0],
  [2, 0],
  [0, 2],
] as const;

it("cuts a polyline at its knots, over its beginning too", () => {
  const starts = edgeStarts(points, knots);
  expect(starts).toEqual([0, 2, 4, 6]);
  if (!starts) throw new Error("there are starts");
  expect([...edgePath(points, starts, 0)]).toEqual([0, 0, 1, 1, 2, 0]);
  expect([...edgePath(points, starts, 2, 2)]).toEqual([0, 2, -1, 1, 0, 0, 1, 1, 2, 0]);
  expect(edgeStarts(points, [[9, 9]])).toBeNull();
});

it("tells how far a point is from a path, at its sides and beyond its ends", () => {
  const path = [0, 0, 4, 0, 4, 3];
  expect(distanceTo(path, 2, 1)).toBe(1);
  expect(distanceTo(path, -3, 4)).toBe(5);
  expect(distanceTo(path, 5, 2)).toBe(1);
  expect(distanceTo([1, 1, 1, 1], 1, 3)).toBe(2);
});
