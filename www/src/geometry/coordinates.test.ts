import { describe, expect, it } from "vitest";
import { panned, screen, toScreen, toWorld, type View, world, zoomed } from "./coordinates";

const size = { width: 800, height: 600 };
const view: View = { x: 0.5, y: -2, scale: 120 };

describe("screen and world", () => {
  it("puts the view's point in the middle, with y up", () => {
    expect(toScreen(world(0.5, -2), view, size)).toEqual(screen(400, 300));
    expect(toScreen(world(0.5, -1), view, size)).toEqual(screen(400, 180));
  });

  it("go back and forth without loss", () => {
    const p = toWorld(screen(37, 512), view, size);
    const q = toScreen(p, view, size);
    expect(q.x).toBeCloseTo(37, 9);
    expect(q.y).toBeCloseTo(512, 9);
  });
});

describe("panned", () => {
  it("keeps the world under the pointer", () => {
    const grabbed = toWorld(screen(100, 100), view, size);
    const moved = toScreen(grabbed, panned(view, 30, -45), size);
    expect(moved.x).toBeCloseTo(130, 9);
    expect(moved.y).toBeCloseTo(55, 9);
  });
});

describe("zoomed", () => {
  it("keeps the point under the pointer where it is", () => {
    const about = screen(650, 90);
    const before = toWorld(about, view, size);
    const after = toWorld(about, zoomed(view, 7.3, about, size, 100), size);
    expect(after.x).toBeCloseTo(before.x, 12);
    expect(after.y).toBeCloseTo(before.y, 12);
  });

  it("stops at both ends of its range", () => {
    const about = screen(400, 300);
    expect(zoomed(view, 1e-30, about, size, 100).scale).toBeGreaterThan(1);
    expect(zoomed(view, 1e300, about, size, 100).scale).toBeLessThan(1e15);
  });
});
