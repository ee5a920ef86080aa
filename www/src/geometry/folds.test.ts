import { expect, it } from "vitest";
import { bernstein, foldedPart, foldedWords } from "./folds";

it("tells how much of a box is turned over", () => {
  expect(foldedPart(2, (place) => place)).toBe(0);
  expect(foldedPart(2, ([x = 0, y = 0]) => [1 - x, y])).toBe(1);
  expect(foldedPart(2, ([x = 0, y = 0]) => [1 - x, 1 - y])).toBe(0);
  expect(foldedPart(3, (place) => place.map((x) => 1 - x))).toBe(1);
  expect(foldedPart(3, (place) => place.map((x) => 2 * x))).toBe(0);
  // Folded at x = 0.6: places from 0.625 on are turned over, 4 of 9.
  expect(foldedPart(3, ([x = 0, y = 0, z = 0]) => [-((x - 0.6) ** 2), y, z])).toBeCloseTo(4 / 9, 12);
});

it("says what to do, and nothing where there is nothing", () => {
  expect(foldedWords(0, "All back")).toBeNull();
  expect(foldedWords(1, "All back")).toMatch(/inside out\. “All back”/);
  expect(foldedWords(0.001, "All back")).toMatch(/About 1%/);
});

it("Bernstein polynomials sum to one, outside as well", () => {
  for (const t of [-0.2, 0, 0.3, 1]) expect(bernstein(t, 5).reduce((a, b) => a + b)).toBeCloseTo(1, 12);
  expect(bernstein(0.25, 2)).toEqual([0.75, 0.25]);
});
