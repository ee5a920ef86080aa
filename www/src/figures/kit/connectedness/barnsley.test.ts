import { describe, expect, it } from "vitest";
import { barnsley, common, cover, nearestPair } from "./barnsley";

describe("barnsley", () => {
  it("has the distances and bounds of the closed form", () => {
    // d = 1 - 2 r + r^(n+1) and 2 s^(n+1) R = 2 r^(n+1), worked out by hand.
    for (const round of barnsley(0.48, 8)) {
      expect(round.distance).toBeCloseTo(1 - 2 * 0.48 + 0.48 ** (round.n + 1), 12);
      expect(round.bound).toBeCloseTo(2 * 0.48 ** (round.n + 1), 12);
    }
  });
  it("proves as soon as 1 - 2 r is more than r^(n+1), and ends there", () => {
    expect(barnsley(0.3, 9).map((round) => round.apart)).toEqual([true]);
    expect(barnsley(0.45, 9).map((round) => round.apart)).toEqual([false, false, true]);
    expect(barnsley(0.49, 9)).toHaveLength(6);
  });
  it("proves nothing at one half and above", () => {
    for (const r of [0.5, 0.55, 0.6]) {
      const rounds = barnsley(r, 9);
      expect(rounds).toHaveLength(9);
      expect(rounds.some((round) => round.apart)).toBe(false);
    }
  });
  it("doubles the points each time, and none wants none", () => {
    expect(barnsley(0.5, 4).map((round) => round.pieces[0].length)).toEqual([1, 2, 4, 8]);
    expect(barnsley(0.5, 0)).toEqual([]);
  });
});

describe("nearestPair", () => {
  it("finds what comparing all finds, interleaved or apart", () => {
    expect(nearestPair([0, 1, 5], [2.5, 4.8, 9])).toEqual([5, 4.8]);
    expect(nearestPair([7, 8], [1, 2])).toEqual([7, 2]);
    expect(nearestPair([1, 3], [3, 4])).toEqual([3, 3]);
  });
});

describe("cover and common", () => {
  it("joins intervals that meet", () => {
    expect(cover([0, 1, 5], 0.5)).toEqual([
      [-0.5, 1.5],
      [4.5, 5.5],
    ]);
    expect(cover([], 1)).toEqual([]);
  });
  it("finds what both hold", () => {
    const p: [number, number][] = [
      [0, 2],
      [3, 6],
    ];
    const q: [number, number][] = [
      [1, 4],
      [5, 5.5],
      [7, 8],
    ];
    expect(common(p, q)).toEqual([
      [1, 2],
      [3, 4],
      [5, 5.5],
    ]);
    expect(common(p, [])).toEqual([]);
  });
});
