/** Figures that a shape in the making begins with: any of them ends in the same attractor. */
import type { Box } from "#geometry/boxes";
import * as messages from "./messages";

export type SeedName = "frame" | "hull" | "square" | "triangle" | "leaf" | "point";

export const SEEDS: readonly { value: SeedName; label: string }[] = [
  { value: "frame", label: messages.boundingRectangle },
  { value: "hull", label: messages.convexHull },
  { value: "square", label: messages.square },
  { value: "triangle", label: messages.triangle },
  { value: "leaf", label: messages.leaf },
  { value: "point", label: messages.point },
];

type Point = readonly [x: number, y: number];

/** Corners on each side of the leaf. */
const LEAF_CORNERS = 12;
/** Half its width, as a part of its height. */
const LEAF_WIDTH = 0.3;
/** A side of a figure is this part of the attractor's at least: that of a line would not be seen. */
const LEAST_SIDE = 0.02;

/** The corners of a figure as large as the attractor; a point has one. */
export function seedCorners(name: SeedName, box: Box, hull: readonly Point[]): readonly Point[] {
  const { x0, y0, x1, y1 } = box;
  const side = Math.max(x1 - x0, y1 - y0) || 1;
  const middle: Point = [(x0 + x1) / 2, (y0 + y1) / 2];
  const at = ([x, y]: Point): Point => [middle[0] + side * x, middle[1] + side * y];
  switch (name) {
    case "frame":
      return [
        [x0, y0],
        [x1, y0],
        [x1, y1],
        [x0, y1],
      ];
    case "hull": {
      const seen = x1 - x0 > LEAST_SIDE * side && y1 - y0 > LEAST_SIDE * side && hull.length > 2;
      return seen ? hull : seedCorners("frame", box, hull);
    }
    case "square":
      return ([-1, 1] as const).flatMap((up) =>
        ([up, -up] as const).map((across) => at([across / 2, up / 2])),
      );
    case "triangle":
      return [at([-0.5, -0.5]), at([0.5, -0.5]), at([0, 0.5])];
    case "leaf":
      return leaf().map(at);
    case "point":
      return [middle];
  }
}

/** A leaf of its own: a tip, a round side, a stalk, a round side, one unit high. */
function leaf(): Point[] {
  const side = Array.from({ length: LEAF_CORNERS + 1 }, (_, i): Point => {
    const up = i / LEAF_CORNERS;
    return [LEAF_WIDTH * Math.sin(Math.PI * up ** 0.8) ** 1.2, up - 0.5];
  });
  const back = side.slice(1, -1).map(([x, y]): Point => [-x, y]);
  return [...side, ...back.reverse()];
}
