import { describe, expect, it } from "vitest";
import { boundaryCount, filled, heightFor, leafBitmap, PRINTED } from "./boundary";

const square = [0, 0, 1, 0, 1, 1, 0, 1];

describe("a leaf as a bitmap", () => {
  it("holds the pixels whose middles are inside", () => {
    const { width, height, inside } = filled(square, 36);
    expect([width, height]).toEqual([36, 36]);
    expect(inside.reduce((sum, one) => sum + one, 0)).toBe(400);
    expect([inside[8 * 36 + 8], inside[7 * 36 + 8], inside[27 * 36 + 27], inside[28 * 36 + 27]]).toEqual([
      1, 0, 1, 0,
    ]);
    expect(boundaryCount({ width, height, inside })).toBe(4 * 19);
  });

  it("is empty within a hole that the outline leaves", () => {
    const notched = [0, 0, 4, 0, 4, 4, 2, 1, 0, 4];
    const { width, inside } = filled(notched, 116);
    expect([inside[20 * width + 12], inside[20 * width + 58], inside[100 * width + 58]]).toEqual([1, 0, 1]);
  });

  it("is drawn so high that its boundary has as many pixels as the paper's", () => {
    const star = Array.from({ length: 60 }, (_, i) => {
      const angle = (Math.PI * i) / 30;
      const radius = i % 2 === 0 ? 1 : 0.6;
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    }).flat();
    const { bitmap, count } = leafBitmap(star);
    expect(Math.abs(count - PRINTED)).toBeLessThan(0.01 * PRINTED);
    expect(boundaryCount(bitmap)).toBe(count);
  });

  it.each([
    ["nothing", []],
    ["a point", [1, 1]],
    ["a line", [0, 0, 1, 0]],
  ])("stays small for %s", (_, points) => {
    const { bitmap } = leafBitmap(points);
    expect(bitmap.height).toBeLessThanOrEqual(2000);
    expect(heightFor(800, 0)).toBe(2000);
  });
});
