import { describe, expect, it } from "vitest";
import type { LocusResult } from "../../../engine/results";
import { BROKEN, HOLDS, NARROWEST, NONE, type Rgb, ramp, shadeOf } from "../../../style/ramp";
import { paint } from "./paint";

/** Relative luminance of WCAG. */
function luminance(colour: Rgb): number {
  const [r, g, b] = colour.map((x) => {
    const s = x / 255;
    return s <= 0.03928 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * (r ?? 0) + 0.7152 * (g ?? 0) + 0.0722 * (b ?? 0);
}
const contrast = (p: Rgb, q: Rgb) => {
  const [low = 0, high = 0] = [luminance(p), luminance(q)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

describe("ramp", () => {
  it("darkens all the way, and starts far from the cream of what holds", () => {
    const steps = Array.from({ length: 101 }, (_, i) => luminance(ramp(i / 100)));
    for (let i = 1; i < steps.length; i++) expect(steps[i]).toBeLessThanOrEqual(steps[i - 1] ?? 0);
    expect(contrast(HOLDS, ramp(0))).toBeGreaterThan(3);
    expect(contrast(HOLDS, BROKEN)).toBeGreaterThan(7);
    expect(contrast(HOLDS, NONE)).toBeGreaterThan(3);
  });
  it("takes anything as a shade", () => {
    expect(ramp(-1)).toEqual(ramp(0));
    expect(ramp(2)).toEqual(ramp(1));
    expect(shadeOf(Number.NaN)).toBe(0);
    expect(shadeOf(0)).toBe(0);
    expect(shadeOf(NARROWEST)).toBe(0);
    expect(shadeOf(1)).toBe(1);
    expect(shadeOf(50)).toBe(1);
    expect(shadeOf(0.1)).toBeGreaterThan(shadeOf(0.01));
  });
});

function field(width: number, height: number, state: number[], gap: number[] = []): LocusResult {
  return {
    width,
    height,
    state: new Uint8Array(state),
    gap: new Float32Array(state.map((_, i) => gap[i] ?? 0)),
    progress: 1,
    bounds: { u0: -1, v0: -1, u1: 2, v1: 2 },
  };
}
const pixel = (pixels: Uint8ClampedArray, size: number, x: number, y: number) =>
  Array.from(pixels.slice(4 * (y * size + x), 4 * (y * size + x) + 4));

describe("paint", () => {
  it("puts the lowest v at the bottom", () => {
    const size = 8;
    const pixels = paint(field(2, 2, [0, 0, 4, 4]), size, "gap");
    expect(pixel(pixels, size, 3, size - 1)).toEqual([...HOLDS, 255]);
    expect(pixel(pixels, size, 3, 0)).not.toEqual([...HOLDS, 255]);
  });
  it("leaves what is not decided clear", () => {
    expect(pixel(paint(field(2, 2, [255, 255, 255, 255]), 4, "gap"), 4, 1, 1)).toEqual([0, 0, 0, 0]);
  });
  it("never smooths the border between whole and broken", () => {
    const size = 40;
    const pixels = paint(field(2, 2, [0, 2, 0, 2], [0, 1, 0, 1]), size, "gap");
    const seen = new Set<string>();
    for (let x = 0; x < size; x++) seen.add(pixel(pixels, size, x, 20).join());
    expect(seen).toEqual(new Set([[...HOLDS, 255].join(), [...ramp(1), 255].join()]));
  });
  it("shades between broken samples", () => {
    const size = 40;
    const pixels = paint(field(2, 2, [2, 2, 2, 2], [NARROWEST, 1, NARROWEST, 1]), size, "gap");
    const row = Array.from({ length: size }, (_, x) => pixel(pixels, size, x, 20).join());
    expect(new Set(row).size).toBeGreaterThan(20);
    expect(row[0]).not.toBe(row[size - 1]);
  });
  it("tells yes from no by a pattern as well as by colour", () => {
    const size = 32;
    const pixels = paint(field(2, 2, [2, 2, 2, 2]), size, "yesno");
    const seen = new Set<string>();
    for (let y = 0; y < size; y++) for (let x = 0; x < size; x++) seen.add(pixel(pixels, size, x, y).join());
    expect(seen.size).toBe(2);
  });
  it("marks where there is no shape, and where it is not known", () => {
    const size = 32;
    for (const state of [3, 4]) {
      const pixels = paint(field(2, 2, [state, state, state, state]), size, "gap");
      const seen = new Set<string>();
      for (let x = 0; x < size; x++)
        seen.add(pixel(pixels, size, x, 7).join()).add(pixel(pixels, size, x, 8).join());
      expect(seen.size).toBe(2);
      expect(seen.has([...HOLDS, 255].join())).toBe(false);
    }
  });
  it("lives with a single sample", () => {
    expect(pixel(paint(field(1, 1, [1]), 4, "gap"), 4, 2, 2)).toEqual([...HOLDS, 255]);
  });
});
