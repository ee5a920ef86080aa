import { describe, expect, it } from "vitest";
import type { LocusView } from "#wasm/api";
import {
  clampedView,
  DEEPEST,
  epsilonOf,
  homeOf,
  LEAST_EPSILON,
  levelOf,
  MOST_ZOOM,
  parameterAt,
  samplesAt,
  viewProblem,
  windowOf,
} from "./window";

const HOME: LocusView = { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 1, w: 0 };

describe("the window of a view", () => {
  it("is all of the plane at zoom 1", () => {
    expect(windowOf(HOME)).toEqual(homeOf("morph"));
    expect(windowOf({ ...HOME, family: "polygon", x: 0, y: 0 })).toEqual(homeOf("polygon"));
  });
  it("shrinks about its middle", () => {
    expect(windowOf({ ...HOME, x: 0.25, y: 1, zoom: 6 })).toEqual({ u0: 0, v0: 0.75, u1: 0.5, v1: 1.25 });
  });
  it("still has a width at the deepest zoom", () => {
    const { u0, u1 } = windowOf({ ...HOME, zoom: MOST_ZOOM });
    expect(u1).toBeGreaterThan(u0);
    // Many numbers of f64 across: pixels differ.
    expect((u1 - u0) / 2 ** -53).toBeGreaterThan(1000);
  });
});

describe("clampedView", () => {
  it("never leaves home", () => {
    for (const zoom of [1, 1.01, 3, 1e6, MOST_ZOOM]) {
      for (const [x, y] of [
        [-50, 0.5],
        [0.5, 1e9],
        [2, -1],
      ] as const) {
        const { u0, v0, u1, v1 } = windowOf(clampedView({ ...HOME, x, y, zoom }));
        expect(u0).toBeGreaterThanOrEqual(-1);
        expect(v0).toBeGreaterThanOrEqual(-1);
        expect(u1).toBeLessThanOrEqual(2);
        expect(v1).toBeLessThanOrEqual(2);
      }
    }
  });
  it("keeps the zoom, the slice and the number of sides in their ranges", () => {
    expect(clampedView({ ...HOME, zoom: 0.1 }).zoom).toBe(1);
    expect(clampedView({ ...HOME, zoom: 1e99 }).zoom).toBe(MOST_ZOOM);
    expect(clampedView({ ...HOME, w: -7 }).w).toBe(-1);
    const polygon = clampedView({ ...HOME, family: "polygon", sides: 4711, w: 0.5 });
    expect([polygon.sides, polygon.w]).toEqual([64, 0]);
  });
  it("leaves a good view as it is", () => {
    const view = { ...HOME, x: 0.3, y: 1.2, zoom: 17, w: 0.25 };
    expect(clampedView(view)).toEqual(view);
  });
});

describe("viewProblem", () => {
  it("knows what cannot be shown", () => {
    expect(viewProblem(HOME)).toBeNull();
    expect(viewProblem({ ...HOME, at: [0.1, 0.2, 0.3] })).toBeNull();
    expect(viewProblem({ ...HOME, at: [0.1, Number.NaN] })).toMatch(/numbers/);
    for (const key of ["x", "y", "zoom", "w", "sides"] as const) {
      expect(viewProblem({ ...HOME, [key]: Number.NaN })).toMatch(/numbers/);
      expect(viewProblem({ ...HOME, [key]: Number.POSITIVE_INFINITY })).toMatch(/numbers/);
    }
    expect(viewProblem({ ...HOME, zoom: 0 })).toMatch(/empty/);
    expect(viewProblem({ ...HOME, zoom: -3 })).toMatch(/empty/);
    expect(viewProblem({ ...HOME, x: 1e6, zoom: 4 })).toMatch(/far/);
    expect(viewProblem({ ...HOME, family: "polygon", y: 1.5 })).toMatch(/far/);
  });
});

describe("levels", () => {
  it("keep about as many samples across any window", () => {
    for (let zoom = 1; zoom < MOST_ZOOM; zoom *= 1.37) {
      const across = (samplesAt(levelOf(zoom)) - 1) / zoom;
      expect(across).toBeGreaterThanOrEqual(170);
      expect(across).toBeLessThanOrEqual(360);
    }
    expect(levelOf(MOST_ZOOM)).toBe(DEEPEST);
  });
  it("halve epsilon each time, down to what f64 can tell", () => {
    expect(epsilonOf(0)).toBe(1 / 600);
    expect(epsilonOf(3)).toBe(1 / 4800);
    expect(epsilonOf(DEEPEST)).toBe(LEAST_EPSILON);
    for (let level = 1; level <= DEEPEST; level++)
      expect(epsilonOf(level)).toBeLessThanOrEqual(epsilonOf(level - 1));
  });
  it("have 0 and 1 among their samples, exactly", () => {
    for (let level = 0; level <= DEEPEST; level++) {
      const third = (samplesAt(level) - 1) / 3;
      expect(parameterAt(-1, 2, level, third)).toBe(0);
      expect(parameterAt(-1, 2, level, 2 * third)).toBe(1);
      expect(parameterAt(-1, 1, level, 1.5 * ((samplesAt(level) - 1) / 2))).toBe(0.5);
    }
  });
});
