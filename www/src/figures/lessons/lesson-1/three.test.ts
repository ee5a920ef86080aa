import { expect, it } from "vitest";
import { unevenGasket } from "../../kit/maps/families";
import { distances, spanningTree } from "../../kit/maps/pieces";
import { apart, gapOf, meets, PAIRS, type Scales, touches } from "./three";

const SCALES: Scales[] = [
  [0.5, 0.5, 0.3],
  [0.52, 0.42, 0.28],
  [0.2, 0.2, 0.2],
  [0.45, 0.5, 0.54],
];

it.each(SCALES)("measures pieces of scales %d, %d and %d as splitting them does", (...scales) => {
  const maps = unevenGasket(scales);
  for (const { between, upper } of distances(maps)) {
    const pair = PAIRS.find(([i, j]) => i === Math.min(...between) && j === Math.max(...between));
    expect(Math.max(0, apart(scales, pair ?? [0, 0]))).toBeCloseTo(upper, 3);
  }
  expect(gapOf(scales)).toBeCloseTo(spanningTree(3, distances(maps)).widest?.upper ?? Number.NaN, 3);
});

it("tells a touch from an overlap and from a gap, in hundredths", () => {
  expect(touches([0.35, 0.65, 0.65], [0, 1])).toBe(true);
  expect(touches([0.35, 0.65, 0.65], [1, 2])).toBe(false);
  expect(meets([0.35, 0.65, 0.65], [1, 2])).toBe(true);
  expect(meets([0.35, 0.64, 0.65], [0, 1])).toBe(false);
  expect(gapOf([0.45, 0.5, 0.55])).toBe(0);
  expect(gapOf([0.45, 0.5, 0.545])).toBeGreaterThan(0);
});
