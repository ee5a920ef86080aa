import { describe, expect, it } from "vitest";
import { apply } from "../../kit/maps/pieces";
import { addresses, onGasket, pieceOf, rightGasket } from "./addresses";

describe("addresses", () => {
  it("of a joint are two, and end alike for ever", () => {
    expect(addresses(0.5, [0.5, 0], 4)).toEqual([
      [0, 1, 1, 1],
      [1, 0, 0, 0],
    ]);
    expect(addresses(0.5, [0, 0], 5)).toEqual([[0, 0, 0, 0, 0]]);
  });
  it("of a hole are none, outside either", () => {
    expect(addresses(0.5, [0.4, 0.4], 4)).toEqual([]);
    expect(addresses(0.5, [-0.1, 0.2], 1)).toEqual([]);
  });
  it("of an overlap are the more, the longer they are, up to as many as are asked for", () => {
    const counts = [1, 4, 5, 6].map((letters) => addresses(0.55, [0.5, 0], letters).length);
    expect(counts).toEqual([2, 2, 4, 4]);
    expect(addresses(0.55, [0.5, 0], 6, 3)).toHaveLength(3);
  });
  it("lead back to the point", () => {
    for (const word of addresses(0.55, [0.46, 0.02], 5)) {
      const [a, b, c] = pieceOf(rightGasket(0.55), word);
      expect(Math.min(a[0], b[0], c[0])).toBeLessThanOrEqual(0.46 + 1e-9);
      expect(Math.max(a[0], b[0], c[0])).toBeGreaterThanOrEqual(0.46 - 1e-9);
    }
  });
});

describe("the nearest point of a gasket", () => {
  it("is the point itself where it is on it, to the last letter", () => {
    const [x, y] = apply(rightGasket(0.5)[2] ?? [1, 0, 0, 1, 0, 0], [0.25, 0]);
    expect(onGasket(0.5, [x, y])).toEqual([x, y]);
  });
  it("is on the rim of a hole, and never farther than a corner", () => {
    const [x, y] = onGasket(0.5, [0.3, 0.3]);
    expect(x + y).toBeCloseTo(0.5, 2);
    for (const far of [
      [9, 9],
      [-3, 0.5],
      [0.5, -2],
    ] as [number, number][]) {
      const [u, v] = onGasket(0.55, far);
      expect(u).toBeGreaterThanOrEqual(0);
      expect(v).toBeGreaterThanOrEqual(0);
      expect(u + v).toBeLessThanOrEqual(1 + 1e-12);
      expect(addresses(0.55, [u, v], 8).length).toBeGreaterThan(0);
    }
  });
});
