import { describe, expect, it } from "vitest";
import { norm, type Point } from "../../kit/maps/pieces";
import { far, metresWords, orbit, pushing, repeated, timesWords, turning, weighed } from "./orbit";

const UP: Point = [0, 1];

describe("a map that turns", () => {
  it("multiplies the distance by its scale at every step", () => {
    for (const scale of [0.5, 0.9, 1, 1.2]) {
      const points = orbit(repeated(turning(scale, 25), 12), [1, 0.3]);
      for (const [n, point] of points.entries())
        expect(far(point)).toBeCloseTo(scale ** n * far([1, 0.3]), 10);
    }
  });
});

describe("the map of the question", () => {
  const map = pushing(0.6, 1.5);
  const points = orbit(repeated(map, 24), UP);

  it("is where the formula says", () => {
    for (const [n, [x, y]] of points.entries()) {
      expect(x).toBeCloseTo(n * 1.5 * 0.6 ** (n - 1), 10);
      expect(y).toBeCloseTo(0.6 ** n, 10);
    }
  });

  it("takes the point away for two steps, and then home", () => {
    const distances = points.map(far);
    expect(Math.max(...distances)).toBe(distances[2]);
    expect(distances[2]).toBeCloseTo(1.84, 2);
    for (let n = 3; n < distances.length; n++) expect(distances[n]).toBeLessThan(distances[n - 1] ?? 0);
    expect(distances[24]).toBeLessThan(0.001);
  });

  it("makes some lengths 1.71 times as long, and none longer than 0.9 times by the other ruler", () => {
    expect(norm(map)).toBeCloseTo(1.71, 2);
    for (let i = 0; i < 360; i++) {
      const at: Point = [Math.cos((i * Math.PI) / 180), Math.sin((i * Math.PI) / 180)];
      const [, next = at] = orbit([map], at);
      expect(weighed(next, 5)).toBeLessThanOrEqual(0.9 * weighed(at, 5) + 1e-12);
    }
  });
});

describe("two maps that bring all points home", () => {
  const side = pushing(0.5, 1);
  const up: typeof side = [0.5, 0, 1, 0.5, 0, 0];
  const end = (maps: (typeof side)[]) => far(orbit(maps, UP).at(-1) ?? UP);

  it("do so alone, and not by turns", () => {
    expect(end(repeated(side, 12))).toBeLessThan(0.01);
    expect(end(repeated(up, 12))).toBeLessThan(0.01);
    expect(end(Array.from({ length: 12 }, (_, i) => (i % 2 === 0 ? side : up)))).toBeGreaterThan(8);
  });
});

it("says how many times as a plain number", () => {
  expect([1.2 ** 30, 1.2 ** 10, 1, 0.9 ** 30, 0.5 ** 30].map(timesWords)).toEqual([
    "240",
    "6.2",
    "1.0",
    "0.042",
    "0.00000000093",
  ]);
});

it("says a length in the unit in which one would say it", () => {
  expect([1, 0.99 ** 60, 0.99 ** 230, 0.99 ** 1000, 0.9 ** 200].map(metresWords)).toEqual([
    "1 m",
    "55 cm",
    "9.9 cm",
    "0.043 mm",
    "less than 0.001 mm",
  ]);
});
