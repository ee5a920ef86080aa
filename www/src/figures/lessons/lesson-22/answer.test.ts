import { expect, it } from "vitest";
import { isQuietAndLively, shares } from "./answer";

it("shares out the lift in powers of the roughness, all of it", () => {
  expect(shares(0, 0)).toEqual([1, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
  expect(shares(9, 0.75)).toEqual([1]);
  expect(new Set(shares(0, 1))).toEqual(new Set([0.1]));
  const some = shares(2, 0.6);
  expect(some).toHaveLength(8);
  expect(some.reduce((sum, one) => sum + one)).toBeCloseTo(1, 12);
  for (const [j, one] of some.slice(1).entries()) expect(one / (some[j] ?? 0)).toBeCloseTo(0.6, 12);
});

it("wants both, quiet and lively", () => {
  expect(isQuietAndLively(0.01, 0.06)).toBe(true);
  expect(isQuietAndLively(0.03, 0.06)).toBe(false);
  expect(isQuietAndLively(0.01, 0.04)).toBe(false);
});
