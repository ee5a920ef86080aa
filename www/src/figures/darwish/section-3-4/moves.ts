/** What the sliders of the page come to: T x = A x + b about the middle of a shape of the plane. */
import { about3, after3, scale3, shift3, turns3 } from "#geometry/maps/affine3";
import { inPlane } from "#geometry/maps/row";
import type { MapRow, Point3 } from "#wasm/api";

/** Degrees; factors; how far x slides with y; in sizes of the shape. */
export interface Moves {
  turn: number;
  size: number;
  slide: number;
  x: number;
  y: number;
}

export const AT_FIRST: Moves = { turn: 40, size: 0.8, slide: 0.3, x: 0.2, y: 0.1 };
export const NONE: Moves = { turn: 0, size: 1, slide: 0, x: 0, y: 0 };

/** Slid, then scaled, then turned about `centre`, then moved by parts of `unit`. */
export function transformOf(
  { turn, size, slide, x, y }: Moves,
  [cx, cy]: readonly [number, number],
  unit: number,
): MapRow {
  const centre: Point3 = [cx, cy, 0];
  const slid = about3([1, slide, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], centre);
  const scaled = about3(scale3([size, size, 1]), centre);
  const turned = about3(turns3([0, 0, (turn * Math.PI) / 180]), centre);
  return inPlane(after3(shift3([x * unit, y * unit, 0]), after3(turned, after3(scaled, slid))));
}
