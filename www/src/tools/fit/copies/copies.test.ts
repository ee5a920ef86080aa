import { expect, it } from "vitest";
import { copyWords, distanceTo, edgePath, edgeStarts, stepWords } from "./copies";

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

const copy = { edge: 3, from: 0, span: 4, ratio: 0.314, across: 0.126, degrees: -14.2, mirrored: true };

it("says size, turn and mirror of a copy", () => {
  expect(copyWords(copy)).toBe(
    "This edge copies that arc of 4 edges: 0.31 times as long, 0.13 times as high, rotated 14° to the right, mirrored.",
  );
  expect(copyWords({ ...copy, degrees: 180, mirrored: false })).toContain("high, rotated by half a turn.");
  expect(copyWords({ ...copy, degrees: 0.2, mirrored: false })).toContain("0.13 times as high.");
  expect(copyWords({ ...copy, degrees: 90, mirrored: false })).toContain("90° to the left.");
});

it("says how far a curve has grown", () => {
  expect([null, 0, 1, 2.5].map(stepWords)).toEqual([
    "all of it",
    "the polygon of knots",
    "1 step",
    "2.5 steps",
  ]);
});
