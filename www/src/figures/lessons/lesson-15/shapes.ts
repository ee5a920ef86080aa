/** The shapes of this lesson. */
import type { Box } from "#document/framing";
import type { MapRow } from "#wasm/api";
import { HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";

export const TRIANGLE: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
export const FERN: Box = { x0: -2.25, y0: 0, x1: 2.7, y1: 10 };

/**
 * A right triangle with sides 0.6, 0.8 and 1, which its height cuts into two of its own shape: (0, 0), (1, 0) and the
 * top go to (0, 0), the top and the foot, and to the top, (1, 0) and the foot.
 */
export const CUT: MapRow[] = [
  [0.36, 0.48, 0.48, -0.36, 0, 0],
  [0.64, -0.48, -0.48, -0.64, 0.36, 0.48],
];
export const CUT_BOX: Box = { x0: 0, y0: 0, x1: 1, y1: 0.48 };
export const TOP: Point = [0.36, 0.48];
export const FOOT: Point = [0.36, 0];
