import { afterEach, expect, it, vi } from "vitest";
import type { MapRow } from "#wasm/api";
import { seenBox, stepsOf, stepsSubject } from "./steps";

// Only the attractor's box is asked of it.
vi.mock("#wasm/core", () => ({
  frond: { bounds: () => ({ min: [0, 0], max: [1, 1], hull: [] }) },
}));

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const GASKET: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0, 0.5],
];

it("has three times as many copies after each step, half as large, coloured by their first map", () => {
  const steps = stepsOf(GASKET);
  expect(steps.slice(0, 4).map((copies) => copies.length)).toEqual([1, 3, 9, 27]);
  expect(steps[2]?.map(({ by }) => by)).toEqual([0, 0, 0, 1, 1, 1, 2, 2, 2]);
  // Map 1 of map 2: the inner one first.
  expect(steps[2]?.[1]?.map).toEqual([0.25, 0, 0, 0.25, 0.25, 0]);
  // No more than can be drawn, and none that cannot be seen.
  expect(Math.max(...steps.map((copies) => copies.length))).toBeLessThanOrEqual(60_000);
});

it("ends with maps that are many, one, none, points or no numbers", () => {
  const small: MapRow = [1e-9, 0, 0, 1e-9, 0.1, 0.2];
  expect(stepsOf(Array.from({ length: 64 }, () => GASKET[0] as MapRow)).length).toBeLessThan(4);
  expect(stepsOf([[0.9, 0, 0, 0.9, 0, 0]]).length).toBeLessThan(20);
  expect(stepsOf([])).toHaveLength(1);
  expect(stepsOf([small, small])).toHaveLength(2);
  expect(stepsOf([[Number.NaN, 0, 0, 1, 0, 0]]).length).toBeLessThan(4);
});

it("leaves room for the attractor and for the copies of the first steps", () => {
  const attractor = { x0: 0, y0: 0, x1: 1, y1: 1 };
  expect(seenBox(stepsOf(GASKET), [[0.5, 0.5]], attractor)).toEqual(attractor);
  expect(seenBox(stepsOf(GASKET), [[3, 0.5]], attractor)).toEqual({ ...attractor, x1: 3 });
});

it("waits for no timer between two frames: in a hidden tab these hardly come", async () => {
  const nothing = () => {};
  class Canvas {
    getContext() {
      return { fill: nothing, stroke: nothing, getImageData: () => ({ data: new Uint8ClampedArray(4) }) };
    }
  }
  class Lines {
    moveTo = nothing;
    lineTo = nothing;
    closePath = nothing;
  }
  vi.stubGlobal("OffscreenCanvas", Canvas);
  vi.stubGlobal("Path2D", Lines);
  vi.useFakeTimers({ toFake: ["setTimeout"] });
  const look = { width: 1, height: 1, smooth: false, ground: "#000000" };
  const drawer = stepsSubject(GASKET, "gasket", "#000000")?.drawer(look);
  const { signal } = new AbortController();
  expect(await drawer?.frame(0, signal)).not.toBeNull();
  expect(await drawer?.frame(1, signal)).not.toBeNull();
  expect(await drawer?.frame(1.5, signal)).toBeNull();
});
