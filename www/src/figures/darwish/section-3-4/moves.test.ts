import { expect, test } from "vitest";
import { applied } from "#geometry/parallelogram";
import { NONE, transformOf } from "./moves";

const round = ({ x, y }: { x: number; y: number }) => [x, y].map((at) => Number(at.toFixed(9)) || 0);

test("nothing is done at rest", () => {
  expect(transformOf(NONE, [3, 1], 2)).toEqual([1, 0, 0, 1, 0, 0]);
});

test("slid, scaled, turned about the middle, and then moved by sizes of the shape", () => {
  const by = transformOf({ turn: 90, size: 2, slide: 0.5, x: 1, y: -1 }, [1, 1], 10);
  expect(round(applied(by, 1, 1))).toEqual([11, -9]);
  // One up is slid by a half, doubled, and turned: (0, 1) becomes (1/2, 1), (1, 2), (-2, 1).
  expect(round(applied(by, 1, 2))).toEqual([9, -8]);
});
