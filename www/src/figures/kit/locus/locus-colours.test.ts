import { describe, expect, it } from "vitest";
import { STATE } from "#geometry/states";
import { colourOf, fieldPixels, HOLDS, NARROW, shade, WIDE } from "./locus-colours";

describe("colourOf", () => {
  it("is white where it holds, darker the wider the gap, clear where nothing is known", () => {
    expect(colourOf(STATE.connected, 0)).toEqual([...HOLDS, 255]);
    expect(colourOf(STATE.touching, 0.5)).toEqual([...HOLDS, 255]);
    expect(colourOf(STATE.disconnected, 1 / 600)).toEqual([...NARROW, 255]);
    expect(colourOf(STATE.disconnected, 1)).toEqual([...WIDE, 255]);
    expect(colourOf(STATE.pending, 0)[3]).toBe(0);
  });
  it("takes any gap", () => {
    expect(shade(Number.NaN)).toBe(0);
    expect(shade(0)).toBe(0);
    expect(shade(99)).toBe(1);
    expect(shade(0.1)).toBeGreaterThan(shade(0.01));
  });
});

describe("fieldPixels", () => {
  it("puts the lowest v at the bottom", () => {
    const bounds = { u0: 0, v0: 0, u1: 1, v1: 1 };
    const field = { width: 1, height: 2, bounds, progress: 1, gap: new Float32Array(2) };
    const pixels = fieldPixels({ ...field, state: new Uint8Array([STATE.connected, STATE.pending]) });
    expect([...pixels]).toEqual([0, 0, 0, 0, ...HOLDS, 255]);
  });
});
