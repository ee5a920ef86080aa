import { describe, expect, it } from "vitest";
import { hullOf } from "./Start";

describe("the hull of points", () => {
  it("goes round the outer ones counter-clockwise, without those on its sides", () => {
    expect(hullOf([0, 0, 1, 1, 0.5, 0.5, 2, 0, 2, 2, 1, 0, 0, 2, 1, 1.9])).toEqual([
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
    ]);
  });
  it("is what there is of no point, one, and points on a line", () => {
    expect(hullOf([])).toEqual([]);
    expect(hullOf([1, 2])).toEqual([[1, 2]]);
    expect(hullOf([0, 0, 1, 1, 2, 2])).toEqual([
      [0, 0],
      [2, 2],
    ]);
  });
});
