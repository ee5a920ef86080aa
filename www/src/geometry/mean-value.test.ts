import { describe, expect, it } from "vitest";
import { carry } from "./mean-value";

/** A star: its notches are deep. */
const star = Float64Array.from({ length: 20 }, (_, i) => {
  const corner = Math.floor(i / 2);
  const radius = corner % 2 === 0 ? 1 : 0.3;
  const angle = (corner * Math.PI) / 5;
  return radius * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
});

function carried(to: Float64Array, x: number, y: number, from = star): [number, number] {
  const out = new Float64Array(2);
  carry(from, [to], 2, x, y, out);
  return [out[0] ?? Number.NaN, out[1] ?? Number.NaN];
}

const PLACES = [
  [0, 0],
  [0.1, 0.2],
  [0.8, 0.01],
  [-0.2, -0.1],
  // In a notch, and outside.
  [0.6, 0.4],
  [1.5, -2],
] as const;

describe("mean value coordinates", () => {
  it("leave a point where it is while no corner moves", () => {
    for (const [x, y] of PLACES) {
      const [a, b] = carried(star, x, y);
      expect(a).toBeCloseTo(x, 10);
      expect(b).toBeCloseTo(y, 10);
    }
  });

  it("carry a point as an affine map does that moves all corners", () => {
    const moved = star.map((_, i) => {
      const [x = 0, y = 0] = star.subarray(i - (i % 2), i - (i % 2) + 2);
      return i % 2 === 0 ? 2 * x - 0.5 * y + 3 : 0.25 * x + y - 1;
    });
    for (const [x, y] of PLACES) {
      const [a, b] = carried(moved, x, y);
      expect(a).toBeCloseTo(2 * x - 0.5 * y + 3, 9);
      expect(b).toBeCloseTo(0.25 * x + y - 1, 9);
    }
  });

  it("carry corners to corners, and edges to edges at the same share", () => {
    const other = star.map((z, i) => (i % 4 === 0 ? 1.5 * z : 0.5 * z) + i / 20);
    for (let corner = 0; corner < 10; corner++) {
      const next = (corner + 1) % 10;
      for (const share of [0, 0.25, 0.5]) {
        const along = (ring: Float64Array, axis: number) =>
          (ring[2 * corner + axis] ?? 0) * (1 - share) + (ring[2 * next + axis] ?? 0) * share;
        const [a, b] = carried(other, along(star, 0), along(star, 1));
        expect(a).toBeCloseTo(along(other, 0), 6);
        expect(b).toBeCloseTo(along(other, 1), 6);
      }
    }
  });

  it("are those of the square's middle for each corner alike", () => {
    const square = Float64Array.of(0, 0, 2, 0, 2, 2, 0, 2);
    const lifted = Float64Array.of(0, 0, 0, 0, 4, 8, 0, 0);
    expect(carried(lifted, 1, 1, square)).toEqual([1, 2]);
  });
});
