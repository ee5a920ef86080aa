/** The leaf that is to be covered: the blade of the maple-like leaf of the gallery, in round numbers. It is 1 high. */
import type { Box } from "#document/framing";
import type { Point } from "../../kit/maps/pieces";

/** Its right half from the tip to the foot; the left half is its mirror image. */
const RIGHT: readonly Point[] = [
  [0, 1],
  [0.08, 0.9],
  [0.2, 0.85],
  [0.16, 0.79],
  [0.27, 0.75],
  [0.25, 0.64],
  [0.41, 0.6],
  [0.58, 0.6],
  [0.54, 0.49],
  [0.48, 0.32],
  [0.52, 0.12],
  [0.4, 0.1],
  [0.26, 0],
  [0.14, 0.16],
  [0, 0.24],
];

export const OUTLINE: readonly Point[] = [
  ...RIGHT,
  ...RIGHT.slice(1, -1)
    .reverse()
    .map(([x, y]): Point => [-x, y]),
];

/** What copies turn and grow about. */
export const CENTRE: Point = [0, 0.45];

/** The leaf with room around it. */
export const BOX: Box = { x0: -0.75, y0: -0.15, x1: 0.75, y1: 1.1 };

/** Whether a point lies in the leaf. */
export function inLeaf([x, y]: Point): boolean {
  let inside = false;
  let [px, py] = OUTLINE.at(-1) ?? [0, 0];
  for (const [qx, qy] of OUTLINE) {
    if (py > y !== qy > y && x < px + ((y - py) / (qy - py)) * (qx - px)) inside = !inside;
    [px, py] = [qx, qy];
  }
  return inside;
}
