import { expect, test } from "vitest";
import { upright, within } from "./decode";

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

test("a picture that lies on its side in the file has its size upright", () => {
  const size = { width: 8000, height: 6000 };
  expect(upright(size, { width: 2364, height: 1773 })).toEqual(size);
  expect(upright(size, { width: 2364, height: 3152 })).toEqual({ width: 6000, height: 8000 });
  expect(upright({ width: 5000, height: 5000 }, { width: 2048, height: 2048 })).toEqual({
    width: 5000,
    height: 5000,
  });
  expect(upright({ width: 9, height: 9 }, { width: 30, height: 20 })).toEqual({ width: 30, height: 20 });
  expect(upright(undefined, { width: 30, height: 20 })).toEqual({ width: 30, height: 20 });
});
