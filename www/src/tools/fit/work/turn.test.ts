import { expect, test } from "vitest";
import { turned } from "./turn";

const size = { width: 30, height: 20 };

test("a corner goes where the corner of the turned picture is", () => {
  // The upper left one, clockwise: to the upper right, the lower right, the lower left.
  expect(turned([0, 0], size, 1)).toEqual([20, 0]);
  expect(turned([0, 0], size, 2)).toEqual([30, 20]);
  expect(turned([0, 0], size, 3)).toEqual([0, 30]);
});

test("there and back is where it was, and so are four quarters", () => {
  const points = [3, 4, 25, 11];
  const lying = { width: 20, height: 30 };
  expect(turned(turned(points, size, 1), lying, 3)).toEqual(points);
  expect(turned(turned(points, size, 2), size, 2)).toEqual(points);
  expect(turned(turned(points, size, 1), lying, 1)).toEqual(turned(points, size, 2));
});
