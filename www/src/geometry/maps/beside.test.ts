import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { beside, oneMore } from "./beside";

const UNIT = { x0: 0, y0: 0, x1: 1, y1: 1 };
const at = (x: number, y: number, s = 0.5): MapRow => [s, 0, 0, s, x, y];

describe("a new map", () => {
  it("takes the place that is free", () => {
    expect(oneMore([at(0, 0), at(0.5, 0), at(0, 0.5)], UNIT)).toEqual(at(0.5, 0.5));
    expect(beside([at(0.5, 0.5), at(0.5, 0), at(0, 0.5)], at(0.5, 0.5), UNIT)).toEqual(at(0, 0));
  });

  it("keeps what it does but for where it goes", () => {
    const turned: MapRow = [0, -0.5, 0.5, 0, 0.5, 0];
    const next = beside([turned], turned, UNIT);
    expect(next.slice(0, 4)).toEqual(turned.slice(0, 4));
    // Its image was the lower left quarter, and is farthest from there in the upper right one.
    expect(next.slice(4)).toEqual([1, 0.5]);
  });

  it("never lies on top of another, however many there are", () => {
    let maps: MapRow[] = [at(0, 0), at(0.5, 0), at(0.25, 0.5)];
    while (maps.length < 64) maps = [...maps, oneMore(maps, UNIT)];
    expect(new Set(maps.map(String)).size).toBe(64);
    for (const [a, , , , e, f] of maps) {
      expect(Math.min(e, f)).toBeGreaterThanOrEqual(0);
      expect(Math.max(e, f) + a).toBeLessThanOrEqual(1.001);
    }
  });

  it("is told in short numbers, although the frame is not", () => {
    const frame = { x0: -2e-5, y0: -2e-5, x1: 1.00002, y1: 1.00002 };
    expect(oneMore([at(0.5, 0), at(0, 0.5), at(0.5, 0.5)], frame)).toEqual(at(0, 0));
  });

  it("goes anywhere that is a place where the shape is a point, or its map fits nowhere", () => {
    const point = { x0: 1, y0: 1, x1: 1, y1: 1 };
    expect(oneMore([at(0.5, 0.5)], point).every(Number.isFinite)).toBe(true);
    expect(beside([at(0, 0)], at(0, 0, 3), UNIT).every(Number.isFinite)).toBe(true);
  });
});
