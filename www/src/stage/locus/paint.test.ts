import { describe, expect, it } from "vitest";
import type { LocusResult } from "#compute/results";
import { BROKEN, HOLDS, NARROWEST, NONE, type Rgb, ramp, shadeOf, TOUCHES, TOUCHES_DOT } from "#style/ramp";
import { crossing, decades, paint } from "./paint";

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
    expect(contrast(TOUCHES, ramp(0))).toBeGreaterThan(2.7);
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
    const pixels = paint(field(2, 2, [0, 0, 4, 4]), size, { style: "gap" });
    expect(pixel(pixels, size, 3, size - 1)).toEqual([...HOLDS, 255]);
    expect(pixel(pixels, size, 3, 0)).not.toEqual([...HOLDS, 255]);
  });
  it("leaves what is not decided clear", () => {
    expect(pixel(paint(field(2, 2, [255, 255, 255, 255]), 4, { style: "gap" }), 4, 1, 1)).toEqual([
      0, 0, 0, 0,
    ]);
  });
  it("never smooths the border between whole and broken", () => {
    const size = 40;
    const pixels = paint(field(2, 2, [0, 2, 0, 2], [0, 1, 0, 1]), size, { style: "gap" });
    const seen = new Set<string>();
    for (let x = 0; x < size; x++) seen.add(pixel(pixels, size, x, 20).join());
    expect(seen).toEqual(new Set([[...HOLDS, 255].join(), [...ramp(1), 255].join()]));
  });
  it("shades between broken samples", () => {
    const size = 40;
    const pixels = paint(field(2, 2, [2, 2, 2, 2], [NARROWEST, 1, NARROWEST, 1]), size, { style: "gap" });
    const row = Array.from({ length: size }, (_, x) => pixel(pixels, size, x, 20).join());
    expect(new Set(row).size).toBeGreaterThan(20);
    expect(row[0]).not.toBe(row[size - 1]);
  });
  it("tells yes from no by a pattern as well as by colour", () => {
    const size = 32;
    const pixels = paint(field(2, 2, [2, 2, 2, 2]), size, { style: "yesno" });
    const seen = new Set<string>();
    for (let y = 0; y < size; y++) for (let x = 0; x < size; x++) seen.add(pixel(pixels, size, x, y).join());
    expect(seen.size).toBe(2);
  });
  it("marks where there is no shape, and where it is not known", () => {
    const size = 32;
    for (const state of [3, 4]) {
      const pixels = paint(field(2, 2, [state, state, state, state]), size, { style: "gap" });
      const seen = new Set<string>();
      for (let x = 0; x < size; x++)
        seen.add(pixel(pixels, size, x, 7).join()).add(pixel(pixels, size, x, 8).join());
      expect(seen.size).toBe(2);
      expect(seen.has([...HOLDS, 255].join())).toBe(false);
    }
  });
  it("lives with a single sample", () => {
    expect(pixel(paint(field(1, 1, [0]), 4, { style: "gap" }), 4, 2, 2)).toEqual([...HOLDS, 255]);
  });
  it("tells what is proved from what only touches, by colour and by dots", () => {
    const size = 64;
    const pixels = paint(field(2, 2, [1, 1, 1, 1]), size, { style: "gap" });
    const counts = new Map<string, number>();
    for (let y = 0; y < size; y++) {
      for (let x = 0; x < size; x++) {
        const colour = pixel(pixels, size, x, y).join();
        counts.set(colour, (counts.get(colour) ?? 0) + 1);
      }
    }
    expect(new Set(counts.keys())).toEqual(new Set([[...TOUCHES, 255].join(), [...TOUCHES_DOT, 255].join()]));
    const dots = counts.get([...TOUCHES_DOT, 255].join()) ?? 0;
    // Calm: a few dots, no texture.
    expect(dots).toBeGreaterThan(4);
    expect(dots).toBeLessThan((size * size) / 10);
  });
  it("shows a part of the field, and nothing beyond it", () => {
    const size = 8;
    const half = field(3, 3, [0, 2, 2, 0, 2, 2, 0, 2, 2], Array(9).fill(1));
    const left = paint(half, size, { style: "gap", window: { u0: -1, v0: -1, u1: -0.4, v1: -0.4 } });
    expect(pixel(left, size, 7, 0)).toEqual([...HOLDS, 255]);
    const beyond = paint(half, size, { style: "gap", window: { u0: -9, v0: -1, u1: 3, v1: 2 } });
    expect(pixel(beyond, size, 0, 4)).toEqual([0, 0, 0, 0]);
  });
  it("is as exact in the depth as at home", () => {
    const [u0, step] = [0.5, 2 ** -50];
    const deep = {
      ...field(
        5,
        5,
        Array.from({ length: 25 }, (_, i) => (i % 5 < 2 ? 0 : 2)),
        Array(25).fill(1),
      ),
      bounds: { u0, v0: u0, u1: u0 + 4 * step, v1: u0 + 4 * step },
    };
    const size = 16;
    const pixels = paint(deep, size, { style: "gap" });
    const row = Array.from(
      { length: size },
      (_, x) => pixel(pixels, size, x, 8).join() === [...HOLDS, 255].join(),
    );
    expect(row).toEqual(row.map((_, x) => (4 * (x + 0.5)) / size < 1.5));
  });
  it("draws a contour where a gap passes a tenth, and a fainter one half-way", () => {
    const size = 300;
    const gaps = [0.02, 0.5, 0.02, 0.5];
    const pixels = paint(field(2, 2, [2, 2, 2, 2], gaps), size, { style: "gap" });
    const light = (x: number) => luminance(pixel(pixels, size, x, 150).slice(0, 3) as unknown as Rgb);
    const lines: number[] = [];
    for (let x = 2; x < size - 1; x++)
      if (light(x) > 1.2 * Math.max(light(x - 1), light(x + 1))) lines.push(x);
    const where = (gap: number) => (size * Math.log(gap / 0.02)) / Math.log(0.5 / 0.02);
    const expected = [10 ** -1.5, 0.1, 10 ** -0.5].map(where);
    expect(lines).toHaveLength(3);
    lines.forEach((x, i) => {
      expect(Math.abs(x - (expected[i] ?? 0))).toBeLessThan(2);
    });
    const at = (i: number) => light(lines[i] ?? 0) / light((lines[i] ?? 0) + 1);
    expect(at(1)).toBeGreaterThan(at(0));
  });
});

describe("contours", () => {
  it("are crossed between neighbours that lie on different sides", () => {
    const nowhere = -1e6;
    expect(crossing(-3, -3, -3)).toBe(0);
    expect(crossing(-3, -4, -3)).toBe(1);
    expect(crossing(-2, -3, -2)).toBe(2);
    expect(crossing(-3, nowhere, nowhere)).toBe(0);
    expect(crossing(nowhere, -3, -2)).toBe(0);
  });
  it("are the powers of ten of the ramp", () => {
    expect(decades(1 / 600).map(({ gap }) => gap)).toEqual([0.01, 0.1]);
    for (const epsilon of [1e-3, 1e-6 / 600, 1e-14]) {
      const found = decades(epsilon);
      expect(found.length).toBeGreaterThanOrEqual(2);
      for (const { at } of found) {
        expect(at).toBeGreaterThan(0);
        expect(at).toBeLessThan(1);
      }
    }
  });
});
