import { expect, test } from "vitest";
import { within } from "./decode";

test("pictures are made as small as they must be, and no smaller", () => {
  expect(within(1746, 1252, 4_194_304)).toEqual({ width: 1746, height: 1252 });
  const { width, height } = within(8000, 5000, 4_194_304);
  expect(width * height).toBeLessThanOrEqual(4_194_304);
  expect(width * height).toBeGreaterThan(4_150_000);
  expect(Math.abs(width / height - 1.6)).toBeLessThan(0.002);
});

test("no side vanishes", () => {
  expect(within(30_000, 1, 10_000)).toEqual({ width: 10_000, height: 1 });
  expect(within(2, 40_000_000, 1000)).toEqual({ width: 1, height: 1000 });
});
