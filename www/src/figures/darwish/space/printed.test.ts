import { expect, test } from "vitest";
import { about3, after3, apply3, shift3, turns3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3 } from "#wasm/api";
import { STATE as II } from "../figure-ii/page";
import { BESIDE, STATE as III } from "../figure-iii/page";
import { STATE as V } from "../figure-v/page";
import { STATE as VI } from "../figure-vi/page";
import * as printed from "./printed";
import { PRINTED_MIDDLE, printedTriangle, pyramid, pyramidMiddle, TRIANGLE_MIDDLE, triangle } from "./shapes";
import { inRadians } from "./turning";

const cornersOf = (maps: readonly MapRow3[]) => maps.map((map) => map.slice(9).map((x) => 2 * x) as Point3);
/** The translations of halves after a move: half of where their corners go. */
const moved = (maps: readonly MapRow3[], by: MapRow3) =>
  cornersOf(maps).map((corner) => apply3(by, corner).map((x) => x / 2));

/** That a table of so many digits shows what can be read in print. */
function shows(translations: readonly number[][], legible: readonly printed.Legible[], digits: number) {
  for (const [map, axis, value] of legible)
    expect(Number(translations[map]?.[axis]?.toFixed(digits)), `map ${map + 1}, axis ${axis}`).toBeCloseTo(
      value,
      9,
    );
}

test("Figures i to iii show every number that can be read", () => {
  const made = triangle("halves");
  shows(moved(made, turns3([0, 0, 0])), printed.FIGURE_I, 2);
  shows(moved(made, turns3(inRadians(II.angles[0]))), printed.FIGURE_II, 2);
  const third = after3(shift3([III.away[0], BESIDE, 0]), turns3(inRadians(III.angles[0])));
  shows(moved(made, third), printed.FIGURE_III, 2);
});

test("Figure iv is the print, and the triangle of the others has its sides", () => {
  expect(printedTriangle()).toEqual([
    [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 15.07, 0.05, -0.02],
    [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 15.34, 0.03, 0.25],
    [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 15.38, 0.32, 0.16],
  ]);
  const sides = (maps: readonly MapRow3[]) => {
    const [a, b, c] = cornersOf(maps) as [Point3, Point3, Point3];
    const apart = (p: Point3, q: Point3) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    return [apart(a, b), apart(b, c), apart(c, a)];
  };
  // A printed coordinate may be 0.005 off, a corner 0.01, and a side 0.02 in each of three directions.
  const own = sides(triangle("halves"));
  for (const [k, side] of sides(printedTriangle()).entries())
    expect(Math.abs(side - (own[k] ?? 0))).toBeLessThan(0.02 * Math.sqrt(3));
  for (const [maps, middle] of [
    [printedTriangle(), PRINTED_MIDDLE],
    [triangle("halves"), TRIANGLE_MIDDLE],
  ] as const)
    for (const k of [0, 1, 2] as const)
      expect(cornersOf(maps).reduce((sum, corner) => sum + corner[k] / 3, 0)).toBeCloseTo(middle[k], 2);
});

test("Figures v and vi stand at the distance of the print, and show every number that can be read", () => {
  const middle = pyramidMiddle(V.away[0]);
  const made = pyramid(middle);
  expect(VI.away[0]).toBe(V.away[0]);
  shows(moved(made, turns3([0, 0, 0])), printed.FIGURE_V, 1);
  shows(moved(made, about3(turns3(inRadians(VI.angles[0])), middle)), printed.FIGURE_VI, 1);
});
