/** The shapes of Darwish & Abd-El-Wahab's figures, as far as they can be told from a print that is cut off. */

import { about3, scale3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3 } from "#wasm/api";
import { FIGURE_IV } from "./printed";

/**
 * Half of a corner is the translation of its map. The second numbers are those under Figure i. The first are
 * reconstructed: by the sides of the triangle under Figure iv, and so that Figure ii is a turn of this one.
 */
const CORNERS: readonly Point3[] = [
  [0.58, 0.12, 0],
  [-0.18, 0, 0],
  [-0.18, 0.6, 0],
];

/** The middle of the triangle as it is made. */
export const TRIANGLE_MIDDLE: Point3 = [0.07, 0.24, 0];

export type Form = "halves" | "sheet";

/**
 * Sierpinski's triangle in space: by maps that halve everything, or by maps that also flatten what is off its plane.
 */
export function triangle(form: Form): MapRow3[] {
  const linear = scale3([0.5, 0.5, form === "halves" ? 0.5 : 0]);
  return CORNERS.map((corner) => about3(linear, corner));
}

/** The triangle of Figure iv, of which all is printed, and its middle. */
export const printedTriangle = (): MapRow3[] =>
  FIGURE_IV.map((translation) => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, ...translation]);
export const PRINTED_MIDDLE: Point3 = [30.53, 0.27, 0.26];

const PYRAMID: readonly Point3[] = [
  [-0.4, -0.4, -0.4],
  [-0.4, 0.4, -0.4],
  [0.4, -0.4, -0.4],
  [0.4, 0.4, -0.4],
  [0, 0, 0.4],
];

/** Five halves, about a point. */
export function pyramid([x, y, z]: Point3): MapRow3[] {
  const half = scale3([0.5, 0.5, 0.5]);
  return PYRAMID.map(([a, b, c]) => about3(half, [a + x, b + y, c + z]));
}

/** How far before the eye its middle is, so that its first translations are those under Figures v and vi. */
export const PYRAMID_AWAY = 30.4;
/** The middle of the pyramid at some distance. */
export const pyramidMiddle = (away: number): Point3 => [away, 0.2, 0];
/** What angle the picture is high. */
export const PYRAMID_ANGLE = 0.06;
