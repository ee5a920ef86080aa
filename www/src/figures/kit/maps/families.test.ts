import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import {
  cutKoch,
  determinant,
  dust,
  fixedPoint,
  gasket,
  HEIGHT,
  PEAK,
  shrink,
  turnedGasket,
  unevenGasket,
} from "./families";
import { apply } from "./pieces";

describe("families", () => {
  it("keep their corners in place, whatever the scale", () => {
    for (const r of [0.1, 0.5, 0.9]) {
      expect(dust(r).map(fixedPoint)).toEqual([
        [0, 0],
        [expect.closeTo(1), 0],
      ]);
      const corners = gasket(r).map(fixedPoint);
      expect(corners[1]?.[0]).toBeCloseTo(1, 12);
      expect(corners[2]?.[0]).toBeCloseTo(0.5, 12);
      expect(corners[2]?.[1]).toBeCloseTo(HEIGHT, 12);
    }
  });
  it("turn the lower left map and nothing else", () => {
    expect(turnedGasket().slice(1)).toEqual(gasket(0.5).slice(1));
    expect(turnedGasket()[0]).toEqual([-0.5, 0, 0, -0.5, 0, 0]);
    expect(determinant(turnedGasket()[0] as MapRow)).toBe(0.25);
  });
});

describe("Koch's curve", () => {
  it("has a peak whose sides part by the cut, and links elsewhere", () => {
    for (const cut of [0, 0.06]) {
      const ends = cutKoch(cut).map((map) => [apply(map, [0, 0]), apply(map, [1, 0])] as const);
      expect(ends[0]?.[1]).toEqual(ends[1]?.[0]);
      expect(ends[2]?.[1]).toEqual(ends[3]?.[0]);
      expect(ends[1]?.[1][1]).toBeCloseTo(PEAK, 12);
      expect((ends[2]?.[0][0] ?? 0) - (ends[1]?.[1][0] ?? 0)).toBeCloseTo(cut, 12);
    }
  });
  it("has four maps of a third each when it is whole", () => {
    for (const map of cutKoch(0)) expect(determinant(map)).toBeCloseTo(1 / 9, 12);
  });
});

it("gives each corner its own scale", () => {
  expect(unevenGasket([0.5, 0.5, 0.5])).toEqual(gasket(0.5));
  expect(unevenGasket([0.2, 0.3, 0.4]).map((map) => map[0])).toEqual([0.2, 0.3, 0.4]);
});

describe("shrink", () => {
  const twisted: MapRow = [0, -0.6, 0.6, 0, 0.3, -0.2];
  it("leaves the fixed points, scales the determinant, and does nothing at 1", () => {
    const [small] = shrink([twisted], 0.5);
    const [x, y] = fixedPoint(twisted);
    expect(fixedPoint(small as MapRow)[0]).toBeCloseTo(x, 12);
    expect(fixedPoint(small as MapRow)[1]).toBeCloseTo(y, 12);
    expect(determinant(small as MapRow)).toBeCloseTo(0.25 * determinant(twisted), 12);
    shrink([twisted], 1)[0]?.forEach((value, i) => {
      expect(value).toBeCloseTo(twisted[i] ?? Number.NaN, 12);
    });
  });
  it("lives with a map that leaves all or none in place", () => {
    expect(fixedPoint([1, 0, 0, 1, 0, 0])).toEqual([0, 0]);
    expect(fixedPoint([1, 0, 0, 1, 2, 0])).toEqual([0, 0]);
  });
});
