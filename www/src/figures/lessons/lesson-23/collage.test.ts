import { describe, expect, it } from "vitest";
import { norm } from "../../kit/maps/pieces";
import {
  ACROSS,
  attractorWorst,
  bound,
  type Copy,
  collageWorst,
  contraction,
  GOOD,
  leafRaster,
  mapOf,
  SIZES,
  START,
  tame,
  UP,
} from "./collage";
import { CENTRE, inLeaf, OUTLINE } from "./leaf";
import { CELL, hausdorff, imageOf, rasterOf, rasterOfPoints } from "./raster";

const disc = (x: number, y: number, r: number) => rasterOf(([u, v]) => Math.hypot(u - x, v - y) <= r);

describe("the distance of two sets", () => {
  it("is that of two discs, whichever comes first", () => {
    const [one, other] = [disc(0, 0, 0.2), disc(0.3, 0.4, 0.1)];
    // The farthest point of the large disc, from the small one.
    expect(Math.abs((hausdorff(one, other)?.distance ?? 0) - 0.6)).toBeLessThan(2 * CELL);
    expect(hausdorff(other, one)?.distance).toBe(hausdorff(one, other)?.distance);
    expect(hausdorff(one, one)?.distance).toBe(0);
  });

  it("joins the two points that it is measured between", () => {
    const found = hausdorff(disc(-0.5, 0, 0.1), disc(0.5, 0.3, 0.1));
    const {
      from: [x, y],
      to: [u, v],
      distance,
    } = found ?? { from: [0, 0], to: [0, 0], distance: 1 };
    expect(Math.hypot(x - u, y - v)).toBeCloseTo(distance, 9);
  });

  it("is none for what is empty, or reaches beyond", () => {
    expect(hausdorff(disc(0, 0, 0.1), disc(9, 9, 0.1))).toBeNull();
    expect(rasterOfPoints(Float64Array.of(0, 0, 3, 0))).toBeNull();
  });
});

describe("a collage", () => {
  it("of the leaf by itself alone leaves nothing", () => {
    const same: Copy = { at: CENTRE, size: 1, width: 1, turn: 0 };
    expect(collageWorst([mapOf(same)])?.distance).toBe(0);
    expect(imageOf(leafRaster(), [mapOf({ ...same, turn: 360 })])).toEqual(leafRaster());
  });

  it("shrinks by the size of its largest copy", () => {
    for (const copy of START) expect(norm(mapOf(copy))).toBeCloseTo(copy.size, 12);
    expect(contraction(START.map(mapOf))).toBeCloseTo(0.5, 12);
  });

  it("keeps Barnsley's promise, at the start and well made", () => {
    for (const copies of [START, GOOD]) {
      const maps = copies.map(mapOf);
      const most = bound(collageWorst(maps)?.distance ?? 0, contraction(maps));
      const is = attractorWorst(maps)?.distance ?? Number.POSITIVE_INFINITY;
      expect(is).toBeGreaterThan(0);
      expect(is).toBeLessThanOrEqual(most + 2 * CELL);
    }
  });

  it("can be made well enough for the exercise, and does not begin so", () => {
    const promised = (copies: readonly Copy[]) => {
      const maps = copies.map(mapOf);
      return bound(collageWorst(maps)?.distance ?? 1, contraction(maps));
    };
    expect(promised(GOOD)).toBeLessThan(0.25);
    expect(promised(START)).toBeGreaterThan(0.3);
  });
});

it("promises nothing of copies that do not shrink", () => {
  expect(bound(0.1, 0.5)).toBeCloseTo(0.2, 12);
  expect(bound(0.1, 1)).toBe(Number.POSITIVE_INFINITY);
});

it("tames what is out of bounds, and keeps copies on the grid", () => {
  expect(tame({ at: [9, -9], size: 2, width: 0, turn: 270 })).toEqual({
    at: [ACROSS[1], UP[0]],
    size: SIZES[1],
    width: 0.3,
    turn: -90,
  });
  const reach = Math.max(...OUTLINE.map(([x, y]) => Math.hypot(x - CENTRE[0], y - CENTRE[1])));
  expect(ACROSS[1] + SIZES[1] * reach).toBeLessThan(1.25);
  expect(UP[0] - SIZES[1] * reach).toBeGreaterThan(-0.8);
  expect(UP[1] + SIZES[1] * reach).toBeLessThan(1.7);
});

it("knows the inside of the leaf", () => {
  expect(inLeaf(CENTRE)).toBe(true);
  expect(inLeaf([0, 0.1])).toBe(false);
  expect(inLeaf([0.26, 0.05])).toBe(true);
});
