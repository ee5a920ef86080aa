/** The shapes of Darwish & Abd-El-Wahab's figures, as far as they can be told from a print that is cut off. */

import { about3, scale3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3 } from "#wasm/api";

const HEIGHT = Math.sqrt(3) / 2;

/** An upright triangle of side 1 about the origin, seen from -y. */
const CORNERS: readonly Point3[] = [
  [-0.5, 0, -HEIGHT / 3],
  [0.5, 0, -HEIGHT / 3],
  [0, 0, (2 * HEIGHT) / 3],
];

export type Form = "halves" | "sheet";

/**
 * Sierpinski's triangle in space: by maps that halve everything, or by maps that also flatten what is off its plane.
 */
export function triangle(form: Form): MapRow3[] {
  const linear = scale3([0.5, form === "halves" ? 0.5 : 0, 0.5]);
  return CORNERS.map((corner) => about3(linear, corner));
}

const PYRAMID: readonly Point3[] = [
  [-0.4, -0.4, -0.3],
  [-0.4, 0.4, -0.3],
  [0.4, 0.4, -0.3],
  [0.4, -0.4, -0.3],
  [0, 0, 0.3],
];

/** Five halves, about a point. */
export function pyramid([x, y, z]: Point3): MapRow3[] {
  const half = scale3([0.5, 0.5, 0.5]);
  return PYRAMID.map(([a, b, c]) => about3(half, [a + x, b + y, c + z]));
}

/** How far before the eye its print has it, and what angle the picture is high. */
export const PYRAMID_AWAY = 15;
export const PYRAMID_ANGLE = 0.075;
