import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { world } from "./coordinates";
import { cornersOf, dragged, middleOf } from "./parallelogram";
import { restsOf, snapped, spun } from "./snap";

const UNIT = { x0: 0, y0: 0, x1: 1, y1: 1 };
const half = (x: number, y: number): MapRow => [0.5, 0, 0, 0.5, x, y];
/** The second of two maps is dragged, the first one covers the lower left quarter. */
const rests = restsOf([half(0, 0), half(0.2, 0.7)], 1, UNIT);
const drag = (
  grip: "origin" | "x" | "y" | "turn",
  x: number,
  y: number,
  map = half(0.2, 0.7),
  reach = 0.03,
) => snapped(map, UNIT, grip, world(x, y), rests, reach);

describe("a map that is dragged", () => {
  it("rests with any corner at a corner", () => {
    expect(drag("origin", 0.51, 0.02)).toEqual({ map: half(0.5, 0), at: world(0.5, 0) });
    // Its far corner at that of the whole.
    expect(drag("origin", 0.49, 0.52).map).toEqual(half(0.5, 0.5));
  });

  it("rests with a corner at another where nothing else of it is near", () => {
    const small: MapRow = [0.4, 0, 0, 0.4, 0.2, 0.7];
    expect(drag("origin", 0.61, 0.59, small).map).toEqual([0.4, 0, 0, 0.4, 0.6, 0.6]);
  });

  it("rests with its middle at a middle, and with a corner at an edge", () => {
    expect(drag("origin", 0.24, 0.26).map).toEqual(half(0.25, 0.25));
    const { map, at } = drag("origin", 0.51, 0.2);
    expect(map).toEqual(half(0.5, 0.2));
    expect(at?.x === 0.5 || at?.x === 1).toBe(true);
  });

  it("goes where it is dragged where nothing is near, or nothing is to be near enough", () => {
    expect(drag("origin", 0.6, 0.3)).toEqual({ map: half(0.6, 0.3), at: null });
    expect(drag("origin", 0.51, 0.02, undefined, 0).map).toEqual(half(0.51, 0.02));
  });

  it("has an end of a side at a corner first, then at a round angle", () => {
    expect(drag("turn", 0.99, 0.98, half(0.2, 0.2)).at).toEqual(world(1, 1));
    const { map } = drag("x", 0.2 + 0.3, 0.7 + 0.31);
    expect(Math.atan2(map[2], map[0])).toBeCloseTo(Math.PI / 4, 12);
    expect(Math.hypot(map[0], map[2])).toBeCloseTo(Math.hypot(0.3, 0.31), 12);
  });

  it("rests at no part of its own", () => {
    expect(restsOf([half(0, 0)], 0, UNIT).points).toHaveLength(5);
    expect(rests.points).toHaveLength(10);
  });
});

describe("a map that is turned", () => {
  const map: MapRow = [0.5, 0.1, 0, 0.25, 0.2, 0.3];
  const middle = middleOf(cornersOf(map, UNIT));
  const at = (degrees: number) => {
    const angle = Math.atan2(0.25, 0.1) + (degrees * Math.PI) / 180;
    return world(middle.x + Math.cos(angle), middle.y + Math.sin(angle));
  };

  it("keeps its middle and its size", () => {
    const next = spun(map, UNIT, at(40), true);
    expect(Math.atan2(next[2], next[0])).toBeCloseTo((40 * Math.PI) / 180, 12);
    expect(Math.hypot(next[0], next[2])).toBeCloseTo(0.5, 12);
    expect(next[0] * next[3] - next[1] * next[2]).toBeCloseTo(0.125, 12);
    const now = middleOf(cornersOf(next, UNIT));
    expect([now.x, now.y]).toEqual([expect.closeTo(middle.x, 12), expect.closeTo(middle.y, 12)]);
  });

  it("rests at a round angle that is near, unless it is to be free", () => {
    expect(
      Math.atan2(...([2, 0].map((i) => spun(map, UNIT, at(43), false)[i]) as [number, number])),
    ).toBeCloseTo(Math.PI / 4, 12);
    expect(spun(map, UNIT, at(40), false)).toEqual(spun(map, UNIT, at(40), true));
  });

  it("stays as it is where the pointer is at its middle, and is turned where it is flat", () => {
    expect(spun(map, UNIT, middle, false)).toBe(map);
    expect(spun([0, 0, 0, 0, 0, 0], UNIT, world(1, 1), false)).toEqual(
      dragged([0, 0, 0, 0, 0, 0], UNIT, "origin", world(0, 0)),
    );
    expect(spun([0.5, 0, 0, 0, 0, 0], UNIT, world(-1, 0), false)[2]).toBeCloseTo(0.5, 12);
  });
});
