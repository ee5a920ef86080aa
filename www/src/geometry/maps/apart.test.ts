import { expect, test } from "vitest";
import type { MapRow, MapRow3, Point3 } from "#wasm/api";
import { about3, after3, scale3, shift3, turns3 } from "./affine3";
import { apartBy, apartWords } from "./apart";

const corners: Point3[] = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const made: MapRow3[] = corners.map((corner) => about3(scale3([0.5, 0.4, 0.3]), corner));
const by = after3(shift3([5, -2, 1]), after3(turns3([0.4, 1.2, -2]), scale3([2, 0.5, 3])));
/** T w T^-1, with the inverse written out. */
const back = after3(
  scale3([0.5, 2, 1 / 3]),
  after3(turns3([0, 0, 0]), after3(inverseTurn(), shift3([-5, 2, -1]))),
);
function inverseTurn(): MapRow3 {
  const [a, b, c, d, e, f, g, h, i] = turns3([0.4, 1.2, -2]);
  return [a, d, g, b, e, h, c, f, i, 0, 0, 0];
}
const now = made.map((map) => after3(by, after3(map, back)));

test("moving the parameters moves the points", () => {
  const apart = apartBy(made, now, by);
  expect(apart.most / apart.size).toBeLessThan(1e-12);
  expect(apart.size).toBeGreaterThan(1);
  expect(apartWords(apart)).toMatch(
    /^2,000 points: apart by less than 10⁻\S+ of its size, which is rounding\.$/,
  );
});

test("what is not the same is told", () => {
  const wrong = now.map((map) => after3(shift3([0.01, 0, 0]), map));
  const apart = apartBy(made, wrong, by);
  expect(apart.most / apart.size).toBeGreaterThan(1e-3);
  expect(apartWords(apart)).toBe("2,000 points: apart by up to 10⁻² of its size.");
  expect(apartWords(apartBy(made, made, shift3([0, 0, 0])))).toBe(
    "All 2,000 points are the same to the last digit.",
  );
  expect(apartBy(made, [[Number.NaN, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]], by).most).toBeNaN();
});

test("in the plane as in space", () => {
  const gasket = [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0.25, 0.433],
  ] as MapRow[];
  // A turn by a right angle and a shift: T w T^-1 by hand.
  const turned = gasket.map(
    ([a, b, c, d, e, f]): MapRow => [d, -c, -b, a, 3 - f - d * 3 + c, 1 + e + b * 3 - a],
  );
  const moved = apartBy(gasket, turned, [0, -1, 1, 0, 3, 1]);
  expect(moved.most / moved.size).toBeLessThan(1e-12);
  expect(moved.size).toBeGreaterThan(1);
  expect(apartBy(gasket, turned, [0, -1, 1, 0, 3, 1.01]).most).toBeCloseTo(0.01, 9);
});
