/** A shape to begin with: so many copies of the unit square, each half as large. */
import { UNIT } from "#geometry/boxes";
import type { MapRow, Shape } from "#wasm/api";
import * as messages from "./messages";

/** Where the lower left corners of the copies are. Three stand as the gasket's do. */
const CORNERS: Record<1 | 2 | 3 | 4, readonly (readonly [number, number])[]> = {
  1: [[0, 0]],
  2: [
    [0, 0],
    [0.5, 0],
  ],
  3: [
    [0, 0],
    [0.5, 0],
    [0.25, 0.5],
  ],
  4: [
    [0, 0],
    [0.5, 0],
    [0, 0.5],
    [0.5, 0.5],
  ],
};

export type BlankCount = keyof typeof CORNERS;
export const BLANK_COUNTS: readonly BlankCount[] = [1, 2, 3, 4];

/** The frame that it is made in. */
export const BLANK_FRAME = UNIT;

export function blankShape(count: BlankCount): Shape {
  return { name: messages.newShape2, maps: CORNERS[count].map(([x, y]): MapRow => [0.5, 0, 0, 0.5, x, y]) };
}
