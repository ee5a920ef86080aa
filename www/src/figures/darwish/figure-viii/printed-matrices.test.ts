import { expect, test } from "vitest";
import {
  FIGURE_VII,
  FIGURE_VIII,
  farthest,
  farthestOfSecond,
  SECOND_VII,
  SECOND_VIII,
  TURN,
  turned,
} from "./printed-matrices";

test("a turn brings what is printed of Figure vii onto the matrix of Figure viii, to the rounding of the print", () => {
  expect(farthest(FIGURE_VII, FIGURE_VIII)).toBeGreaterThan(0.2);
  // Two decimals are printed: 0.005 either way.
  expect(farthest(turned(FIGURE_VII, TURN), FIGURE_VIII)).toBeLessThan(0.005);
});

test("the same turn brings the last row of a second matrix onto two columns of it, to the rounding of the print", () => {
  expect(SECOND_VII).toEqual([0.05, -0.42, 0.34]);
  expect(SECOND_VIII.flat()).toEqual([0.18, -0.31, -0.23, 0.42, 0.26, -0.3]);
  // Each is a sum of three numbers that may be 0.005 off, by cosines; on either side.
  expect(farthestOfSecond()).toBeLessThan(2 * 0.005 * Math.sqrt(3));
  expect(farthestOfSecond()).toBeCloseTo(0.0038, 4);
});

test("it shrinks a plane to 0.54 and flattens what is across", () => {
  const columns = [0, 1, 2].map((k) => FIGURE_VIII.map((row) => row[k] ?? 0));
  const dot = (p: readonly number[], q: readonly number[]) =>
    p.reduce((sum, x, i) => sum + x * (q[i] ?? 0), 0);
  const [a = [], b = [], c = []] = columns;
  // The squares of the three stretches add up to this; in pairs multiplied to that; and all three to the square of det.
  const sum = dot(a, a) + dot(b, b) + dot(c, c);
  const pairs =
    dot(a, a) * dot(b, b) -
    dot(a, b) ** 2 +
    (dot(b, b) * dot(c, c) - dot(b, c) ** 2) +
    (dot(a, a) * dot(c, c) - dot(a, c) ** 2);
  expect(sum).toBeCloseTo(2 * 0.54 ** 2, 2);
  expect(pairs).toBeCloseTo(0.54 ** 4, 2);
  const det = dot(a, [
    (b[1] ?? 0) * (c[2] ?? 0) - (b[2] ?? 0) * (c[1] ?? 0),
    (b[2] ?? 0) * (c[0] ?? 0) - (b[0] ?? 0) * (c[2] ?? 0),
    (b[0] ?? 0) * (c[1] ?? 0) - (b[1] ?? 0) * (c[0] ?? 0),
  ]);
  expect(Math.abs(det)).toBeLessThan(0.002);
});
