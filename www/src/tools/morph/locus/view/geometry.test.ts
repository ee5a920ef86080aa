import { describe, expect, it } from "vitest";
import { clampedView, MOST_ZOOM, windowOf } from "#compute/locus/window";
import type { LocusView } from "#wasm/api";
import {
  arcNear,
  between,
  countOf,
  digitsOf,
  originOf,
  roundedTo,
  spot,
  ticksOf,
  wholeOf,
  zoomed,
} from "./geometry";

const HOME = wholeOf("morph");
const at = (view: LocusView, [px, py]: [number, number]) => {
  const { u0, u1, v0, v1 } = windowOf(view);
  return [u0 + px * (u1 - u0), v0 + py * (v1 - v0)] as const;
};

describe("zoomed", () => {
  it("keeps what is under the pointer, however near", () => {
    const place: [number, number] = [0.2, 0.9];
    let view = HOME;
    const [u, v] = at(view, place);
    for (let i = 0; i < 60; i++) {
      view = zoomed(view, 1.6, place);
      const [x, y] = at(view, place);
      const pixel = 3 / view.zoom / 1000;
      expect(Math.abs(x - u)).toBeLessThan(Math.max(pixel, 1e-15));
      expect(Math.abs(y - v)).toBeLessThan(Math.max(pixel, 1e-15));
    }
    expect(view.zoom).toBeGreaterThan(1e12);
    expect(zoomed(view, 1e9, place).zoom).toBe(MOST_ZOOM);
  });
  it("comes back home", () => {
    const near = zoomed(HOME, 50, [0.1, 0.1]);
    expect(clampedView(zoomed(near, 1e-9, [0.7, 0.3]))).toEqual(HOME);
  });
});

describe("between", () => {
  const from = { ...HOME, x: 0.4, y: 0.6, zoom: 2 };
  const to = { ...HOME, x: 1.1, y: 1.2, zoom: 4000 };
  it("begins and ends where it should", () => {
    expect(between(from, to, 0)).toMatchObject({ x: 0.4, y: 0.6, zoom: 2 });
    expect(between(from, to, 1)).toBe(to);
  });
  it("never loses sight of where it goes, on the way in and on the way out", () => {
    for (let s = 0; s <= 1; s += 0.05) {
      for (const view of [between(from, to, s), between(to, from, 1 - s)]) {
        const { u0, u1, v0, v1 } = windowOf(view);
        expect(u0).toBeLessThanOrEqual(to.x);
        expect(u1).toBeGreaterThanOrEqual(to.x);
        expect(v0).toBeLessThanOrEqual(to.y);
        expect(v1).toBeGreaterThanOrEqual(to.y);
      }
    }
  });
  it("moves evenly where the zoom stays", () => {
    expect(between(from, { ...from, x: 0.8 }, 0.5)).toMatchObject({ x: 0.6000000000000001, zoom: 2 });
  });
});

describe("roundedTo", () => {
  it("loses less than a pixel", () => {
    for (let zoom = 1; zoom < MOST_ZOOM; zoom *= 3.3) {
      const view = { ...HOME, x: Math.SQRT1_2, y: 1 / 3, zoom };
      const { x, y, zoom: near } = roundedTo(view);
      expect(Math.abs(x - view.x) * zoom).toBeLessThan(3 / 2000);
      expect(Math.abs(y - view.y) * zoom).toBeLessThan(3 / 2000);
      expect(near / zoom).toBeCloseTo(1, 5);
    }
  });
  it("keeps numbers short in a link", () => {
    expect(roundedTo({ ...HOME, x: 1 / 3, y: 2 / 3, zoom: 7.123456789, w: 1 / 7 })).toMatchObject({
      x: 0.33333,
      y: 0.66667,
      zoom: 7.12346,
      w: 0.142857,
    });
  });
});

describe("numbers of a window", () => {
  it("have as many digits as tell its pixels apart", () => {
    expect(digitsOf(1)).toBe(2);
    expect(digitsOf(1000)).toBe(5);
    expect(digitsOf(1e13)).toBe(15);
  });
  it("are round", () => {
    expect(ticksOf(-1, 2, 3)).toEqual({ at: [-1, 0, 1, 2], digits: 0 });
    expect(ticksOf(-1, 1, 4)).toEqual({ at: [-1, -0.5, 0, 0.5, 1], digits: 1 });
    expect(ticksOf(0.5931, 0.6819, 3)).toEqual({ at: [0.6, 0.65], digits: 2 });
  });
  it("are few, at any depth", () => {
    for (let zoom = 1; zoom < MOST_ZOOM; zoom *= 2.7) {
      const { u0, u1 } = windowOf({ ...HOME, x: 0.7, zoom });
      const { at: ticks } = ticksOf(u0, u1, 3);
      expect(ticks.length).toBeGreaterThanOrEqual(1);
      expect(ticks.length).toBeLessThanOrEqual(9);
    }
  });
});

describe("ticks far down", () => {
  it("are counted from a number that is written once, and tell every place", () => {
    for (let zoom = 1; zoom <= MOST_ZOOM; zoom *= 3.1) {
      const { u0, u1 } = windowOf({ ...HOME, x: 0.371859123456, zoom });
      const { at, digits } = ticksOf(u0, u1, 3);
      const origin = originOf(u0, u1, digits);
      if (origin === null) {
        expect(digits).toBeLessThanOrEqual(3);
        continue;
      }
      const counts = at.map((x) => countOf(x, origin));
      expect(new Set(counts).size).toBe(at.length);
      at.forEach((x, k) => {
        expect(String(counts[k]).length).toBeLessThanOrEqual(4);
        const told = origin.at + (counts[k] ?? 0) * origin.unit;
        expect(Math.abs(told - x)).toBeLessThan(1e-3 * (u1 - u0) + 1e-15);
      });
    }
  });
  it("keep what they are counted from when one moves a little", () => {
    const at = (x: number) => {
      const { u0, u1 } = windowOf({ ...HOME, x, zoom: 1e6 });
      return originOf(u0, u1, ticksOf(u0, u1, 3).digits)?.at;
    };
    expect(at(0.3718)).toBe(0.3718);
    expect(at(0.3718 + 1e-7)).toBe(0.3718);
  });
});

describe("spot", () => {
  const card = { width: 140, height: 180 };
  const page = { width: 1440, height: 900 };
  it("is left of the square where there is room, so that nothing is hidden", () => {
    const found = spot({ x: 1200, y: 400 }, { left: 1100, right: 1420 }, card, page, false);
    expect(found).toEqual({ left: 946, top: 310 });
  });
  it("is over the point on a narrow page, clear of the finger, and within it", () => {
    const phone = { width: 390, height: 844 };
    const found = spot({ x: 380, y: 600 }, { left: 30, right: 380 }, card, phone, true);
    expect(found).toEqual({ left: 242, top: 372 });
    const high = spot({ x: 5, y: 100 }, { left: 30, right: 380 }, card, phone, true);
    expect(high.top).toBeGreaterThan(100);
    expect(high.left).toBe(8);
  });
});

describe("arcNear", () => {
  const window = { u0: -1, v0: -1, u1: 1, v1: 1 };
  it("is the whole circle at home, and nothing where it does not come near", () => {
    const arc = arcNear(0.7, window) ?? [];
    expect(arc.every(([x, y]) => Math.abs(Math.hypot(x, y) - 0.7) < 1e-12)).toBe(true);
    expect(arc[0]?.[0]).toBeCloseTo(arc.at(-1)?.[0] ?? 0, 9);
    expect(arcNear(0.7, { u0: 0, v0: 0, u1: 0.1, v1: 0.1 })).toBeNull();
  });
  it("spans a small window", () => {
    const near = { u0: 0.4999, v0: 0.4999, u1: 0.5001, v1: 0.5001 };
    const arc = arcNear(Math.SQRT1_2, near) ?? [];
    const xs = arc.map(([x]) => x);
    expect(Math.min(...xs)).toBeLessThan(near.u0);
    expect(Math.max(...xs)).toBeGreaterThan(near.u1);
    expect(Math.max(...xs) - Math.min(...xs)).toBeLessThan(0.001);
  });
});
