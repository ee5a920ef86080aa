import { describe, expect, it } from "vitest";
import {
  atResolution,
  clearanceOf,
  provedPart,
  STATE,
  stateNear,
  statesAlong,
  stretches,
  widestOf,
} from "./states";

const { connected, touching, disconnected, hidden, none, undecided } = STATE;

describe("stretches", () => {
  it("reaches half a sample to both sides", () => {
    expect(stretches([touching, disconnected, touching, touching, touching])).toEqual([
      { t0: 0.125, t1: 0.375 },
    ]);
  });

  it("stops at both ends", () => {
    expect(stretches([disconnected, none, disconnected])).toEqual([{ t0: 0, t1: 1 }]);
    expect(stretches([connected, touching, disconnected])).toEqual([{ t0: 0.75, t1: 1 }]);
  });

  it("does not call the undecided broken", () => {
    expect(stretches([undecided, undecided])).toEqual([]);
    expect(stretches([])).toEqual([]);
  });
});

describe("stateNear", () => {
  const field = {
    width: 3,
    height: 3,
    bounds: { u0: 0, v0: 0, u1: 2, v1: 2 },
    state: Uint8Array.from([2, 2, 2, 2, 1, 2, 2, 2, 2]),
    gap: new Float32Array(9),
  };

  it("lets a sample speak for itself", () => {
    expect(stateNear(field, [1, 1])).toBe(touching);
    expect(stateNear(field, [0, 1])).toBe(disconnected);
  });

  it("gives a thin isthmus the benefit of the doubt between samples", () => {
    expect(stateNear(field, [0.6, 0.6])).toBe(touching);
  });

  it("knows nothing outside", () => {
    expect(stateNear(field, [9, 9])).toBe(STATE.pending);
  });

  it("marks the broken ends of a path", () => {
    const ends: [number, number][] = [
      [0, 0],
      [2, 2],
    ];
    expect(stretches(statesAlong(field, ends, 5))).toEqual([
      { t0: 0, t1: 0.125 },
      { t0: 0.875, t1: 1 },
    ]);
  });
});

describe("atResolution", () => {
  it("keeps a gap within epsilon apart from one that is seen, and from none", () => {
    expect(atResolution(disconnected, 0.001, 1 / 600)).toBe(hidden);
    expect(atResolution(disconnected, 0.002, 1 / 600)).toBe(disconnected);
    expect(atResolution(none, Number.NaN, 1 / 600)).toBe(none);
    expect(atResolution(connected, 0, 1 / 600)).toBe(connected);
  });
});

describe("provedPart", () => {
  it("is of what holds, whatever else there is", () => {
    const { connected, touching, disconnected, pending } = STATE;
    expect(provedPart([connected, touching, disconnected, connected, pending, touching])).toBe(0.5);
    expect(provedPart([connected])).toBe(1);
    expect(provedPart([disconnected, STATE.hidden, pending])).toBeNull();
    expect(provedPart([])).toBeNull();
  });
});

describe("widestOf", () => {
  it("finds the widest gap, in the middle of a level stretch", () => {
    const states = [touching, disconnected, disconnected, disconnected, connected];
    expect(widestOf(states, [0, 0.01, 0.03, 0.03, 0])).toEqual({ t: 0.625, gap: 0.03 });
  });

  it("counts neither what touches nor what has no shape", () => {
    expect(widestOf([touching, none, undecided], [0.5, Number.NaN, 0.2])).toBeNull();
    expect(widestOf([], [])).toBeNull();
    expect(widestOf([disconnected], [Number.NaN])).toBeNull();
    expect(widestOf([disconnected], [0.2])).toEqual({ t: 0, gap: 0.2 });
  });
});

describe("clearanceOf", () => {
  const half = (broken: (u: number, v: number) => boolean) => ({
    width: 31,
    height: 31,
    bounds: { u0: -1, v0: -1, u1: 2, v1: 2 },
    state: Uint8Array.from({ length: 31 * 31 }, (_, i) =>
      broken(-1 + (i % 31) / 10, -1 + Math.floor(i / 31) / 10) ? disconnected : touching,
    ),
    gap: new Float32Array(31 * 31),
  });
  const straight = [
    [0, 0],
    [1, 1],
  ] as [number, number][];

  it("is the distance to the nearest broken sample, away from the ends", () => {
    expect(
      clearanceOf(
        half((u, v) => v > 1.45 && u < 0.55),
        straight,
      ),
    ).toBeCloseTo(Math.hypot(0.41, 0.59), 1);
    // Broken behind the first shape: that counts as little as the end itself.
    expect(
      clearanceOf(
        half((u) => u < -0.05),
        straight,
      ),
    ).toBeGreaterThan(0.15);
  });

  it("has no bound where nothing is broken", () => {
    expect(
      clearanceOf(
        half(() => false),
        straight,
      ),
    ).toBe(Number.POSITIVE_INFINITY);
  });
});
