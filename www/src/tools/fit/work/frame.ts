/** Where what was opened lies in the plane: all of it in a square of side 2 about the origin, whatever its units. */

import type { Box } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";

export interface Frame {
  /** Of the source. */
  x: number;
  y: number;
  /** Units of the plane a unit of the source. */
  scale: number;
}

export const PLAIN: Frame = { x: 0, y: 0, scale: 1 };

/** The frame of a rectangle from the origin: that of a picture. */
export function frameOfSize(width: number, height: number): Frame {
  return { x: width / 2, y: height / 2, scale: 2 / Math.max(width, height, 1) };
}

export function frameOfPoints(points: Float64Array): Frame {
  const { x0, y0, x1, y1 } = boxOf(points);
  const size = Math.max(x1 - x0, y1 - y0);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale: size > 0 && Number.isFinite(size) ? 2 / size : 1 };
}

/** x0, y0, x1, y1, .. of the source in the plane. */
export function framed(points: Float64Array, { x, y, scale }: Frame): Float64Array {
  return points.map((z, i) => (z - (i % 2 === 0 ? x : y)) * scale);
}

/** The box of x0, y0, x1, y1, ..; without points the square of side 2. */
export const boxOf = (points: Float64Array): Box => boxOfPoints(points) ?? { x0: -1, y0: -1, x1: 1, y1: 1 };
