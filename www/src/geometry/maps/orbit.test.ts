import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { imageOf } from "./affine2";
import {
  addressOf,
  hash,
  nearestOn,
  orbitOf,
  type Point,
  piecesAt,
  pointAt,
  preimageOf,
  thrown,
} from "./orbit";

const HEIGHT = Math.sqrt(3) / 2;
const GASKET: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, HEIGHT / 2],
];
const BOX = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const FERN: MapRow[] = [
  [0, 0, 0, 0.16, 0, 0],
  [0.85, 0.04, -0.04, 0.85, 0, 1.6],
  [0.2, -0.26, 0.23, 0.22, 0, 1.6],
  [-0.15, 0.28, 0.26, 0.24, 0, 0.44],
];
const FERN_BOX = { x0: -2.2, y0: 0, x1: 2.7, y1: 10 };

const near = (p: Point, q: Point, digits = 9) => {
  expect(p[0]).toBeCloseTo(q[0], digits);
  expect(p[1]).toBeCloseTo(q[1], digits);
};

describe("an orbit", () => {
  it("puts the last map first in the address of where it leads", () => {
    const letters = [0, 2, 1];
    const points = orbitOf(GASKET, [0.3, 0.3], letters);
    expect(points).toHaveLength(4);
    expect(addressOf(letters)).toEqual([1, 2, 0]);
    // The last map decides in which large piece the point is, whatever came before.
    expect(points.at(-1)?.[0]).toBeGreaterThan(0.5);
    // And by the address, from any point of the shape.
    near(orbitOf(GASKET, pointAt(GASKET, [2]), letters).at(-1) as Point, pointAt(GASKET, [1, 2, 0, 2]));
  });

  it("ends where a map is gone", () => {
    expect(orbitOf(GASKET, [0, 0], [1, 7, 1])).toHaveLength(2);
    expect(orbitOf([], [0.5, 0.5], [0])).toEqual([[0.5, 0.5]]);
  });
});

describe("the address of a point", () => {
  it("is read from where the point lies", () => {
    for (const address of [[1, 2, 0, 0, 1], [2, 2, 2, 1], [0]]) {
      const point = pointAt(GASKET, [...address, 1, 2, 0, 2, 1]);
      const found = nearestOn(GASKET, BOX, point);
      expect(found?.distance).toBeLessThan(1e-10);
      expect(found?.address.slice(0, address.length)).toEqual(address);
    }
  });

  it("of a point that two pieces share is the first, and both pieces are known", () => {
    expect(nearestOn(GASKET, BOX, [0.5, 0])?.address.slice(0, 4)).toEqual([0, 1, 1, 1]);
    expect(piecesAt(GASKET, BOX, [0.5, 0])).toEqual([0, 1]);
    expect(piecesAt(GASKET, BOX, [0.25, 0])).toEqual([0]);
    expect(piecesAt(GASKET, BOX, [0.5, HEIGHT / 3])).toEqual([]);
  });

  it("says how far a point is that is not on the shape", () => {
    // The middle of the hole is a third of the height of the hole from each of its sides.
    expect(nearestOn(GASKET, BOX, [0.5, HEIGHT / 3])?.distance).toBeCloseTo(HEIGHT / 6, 2);
    expect(nearestOn(GASKET, BOX, [2, 0])?.distance).toBeCloseTo(1, 2);
    expect(nearestOn(GASKET, BOX, [2, 0])?.sure).toBe(true);
    // Of a fern, whose pieces shrink by little, too.
    expect(nearestOn(FERN, FERN_BOX, [2.5, 0.5])?.sure).toBe(true);
    expect(nearestOn(GASKET, BOX, [2, 0], { within: 0.5 })).toBeNull();
  });

  it("needs no inverse: a stem that is flattened has addresses, too", () => {
    const point = pointAt(FERN, [1, 1, 0, 1, 2]);
    const found = nearestOn(FERN, FERN_BOX, point);
    expect(found?.distance).toBeLessThan(1e-9);
    near(pointAt(FERN, found?.address ?? []), point, 8);
    expect(preimageOf(FERN[0] as MapRow, [0, 1])).toBeNull();
    near(preimageOf(FERN[1] as MapRow, imageOf(FERN[1] as MapRow, [1, 2])) as Point, [1, 2]);
  });

  it("ends for one map, for many, and for pieces that lie on each other", () => {
    const one: MapRow[] = [[0.5, 0, 0, 0.5, 0.5, 0]];
    expect(nearestOn(one, { x0: 1, y0: 0, x1: 1, y1: 0 }, [1, 0])?.distance).toBe(0);
    const many = Array.from({ length: 255 }, (_, i): MapRow => [1 / 255, 0, 0, 1 / 255, i / 255, 0]);
    expect(nearestOn(many, { x0: 0, y0: 0, x1: 1, y1: 0 }, [0.5, 0])?.address[0]).toBe(127);
    const twice = [...GASKET, ...GASKET];
    expect(nearestOn(twice, BOX, [0.25, 0])?.address[0]).toBe(0);
    expect(piecesAt(twice, BOX, [0.25, 0])).toEqual([0, 3]);
  });
});

describe("a throw", () => {
  it("is fair where there are no weights, and follows those there are", () => {
    expect([0, 0.34, 0.99].map((chance) => thrown(3, chance))).toEqual([0, 1, 2]);
    expect([0, 0.5, 0.99].map((chance) => thrown(3, chance, [0, 1, 0]))).toEqual([1, 1, 1]);
    expect(thrown(3, 0.999999, [0.1, 0.2, 0.3])).toBe(2);
    expect(thrown(3, 0.5, [0, 0, 0])).toBe(1);
  });
});

it("hashes evenly into 32 bits", () => {
  const ones = Array.from({ length: 4096 }, (_, n) => hash(n));
  expect(new Set(ones).size).toBe(4096);
  expect(ones.every((x) => Number.isInteger(x) && x >= 0 && x < 2 ** 32)).toBe(true);
});
