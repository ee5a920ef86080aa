import { describe, expect, it } from "vitest";
import { compose } from "../../kit/maps/pieces";
import { boxesOf, GRIDDED, moran, REPEATED } from "./boxes";

describe("boxes", () => {
  it.each([
    ["line", 2],
    ["square", 4],
    ["gasket", 3],
    ["carpet", 8],
  ] as const)("of the %s are %i times as many in every finer grid", (name, times) => {
    const shape = GRIDDED[name];
    for (let level = 0; level <= shape.most; level++)
      expect(boxesOf(shape, level).length).toBe(times ** level);
  });

  it("lie within the grid, and a level that there is not is the nearest", () => {
    const side = 2 ** GRIDDED.gasket.most;
    for (const [column, row] of boxesOf(GRIDDED.gasket, 100)) {
      expect(column + row).toBeLessThan(side);
      expect(Math.min(column, row)).toBeGreaterThanOrEqual(0);
    }
    expect(boxesOf(GRIDDED.gasket, -3)).toEqual([[0, 0]]);
  });
});

describe("Moran's equation", () => {
  it("gives what is known", () => {
    expect(moran([0.5, 0.5])).toBeCloseTo(1, 12);
    expect(moran([0.5, 0.5, 0.5])).toBeCloseTo(Math.log(3) / Math.log(2), 12);
    expect(moran(Array(8).fill(1 / 3))).toBeCloseTo(Math.log(8) / Math.log(3), 12);
    expect(moran([0.25, 0.25])).toBeCloseTo(0.5, 12);
    expect(moran([0.5, 0.25, 0.25])).toBeCloseTo(Math.log2((1 + Math.sqrt(5 + 4)) / 2), 12);
  });

  it("says too much of a shape with a piece that lies on another", () => {
    const [first, second] = REPEATED;
    const last = REPEATED.at(-1);
    expect(first && second && compose(first, second)).toEqual(last);
    // x = (1/2)^D is a root of 3 x + x^2 = 1.
    expect(2 ** -moran(REPEATED.map(([a]) => a))).toBeCloseTo((Math.sqrt(13) - 3) / 2, 12);
  });

  it("solves itself for uneven scales, near 0 and near 1", () => {
    for (const scales of [
      [0.9, 0.1],
      [0.001, 0.002],
      [0.99, 0.99, 0.99],
    ]) {
      const d = moran(scales);
      expect(scales.reduce((sum, r) => sum + r ** d, 0)).toBeCloseTo(1, 9);
    }
  });
});
