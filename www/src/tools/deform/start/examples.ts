/** A bend to begin with, for whoever wants to be shown. */

import { type Point, rest, rounder } from "#geometry/mesh";
import type { BoundingBox, Deformation, Shape } from "#wasm/api";
import * as messages from "../messages";
import { withMotion } from "./motions";

/** Shapes that grow from the ground. */
const GROWN: readonly string[] = ["fern", "tree", "twigs", "maple", "oak"];

export interface Example {
  deformation: Deformation;
  /** What is to be seen, in a sentence. */
  words: string;
  moves: boolean;
}

/** What shows best on a shape: what grows sways, of all else the longest side is lifted in the middle. */
export function exampleOf(
  deformation: Deformation,
  shape: Pick<Shape, "preset">,
  { hull }: Pick<BoundingBox, "hull">,
): Example {
  const plain: Deformation = { ...deformation, kb: 0, ke: 9, delta: 0.75, superposed: true, on: true };
  if (shape.preset !== undefined && GROWN.includes(shape.preset))
    return {
      deformation: withMotion(flat(plain), "sway"),
      words: messages.swaysAndEveryPart,
      moves: true,
    };
  return {
    deformation: { ...lifted(plain, hull), spin: "none" },
    words: messages.oneSideLiftedIn,
    moves: false,
  };
}

/** At rest, at all times. */
function flat(deformation: Deformation): Deformation {
  const { columns, rows } = deformation;
  return {
    ...deformation,
    keys: [{ at: 0, moves: new Array<number>(2 * columns * rows).fill(0) }],
    phase: 0,
  };
}

/** How far the middle of the side goes, and how wide its influence is, in parts of the box's mean side. */
const PULLED_BY = 0.4;
const WIDE = 0.35;

function lifted(deformation: Deformation, hull: readonly Point[]): Deformation {
  const { columns, rows, box } = deformation;
  const size = Math.sqrt((box[2] - box[0]) * (box[3] - box[1]));
  const { middle, outward } = longestSide(hull);
  const round = rounder(size);
  const moves = Array.from({ length: columns * rows }, (_, i) => {
    const [x, y] = rest(deformation, i);
    const far = Math.hypot(x - middle[0], y - middle[1]) / (WIDE * size);
    const much = PULLED_BY * size * Math.exp(-far * far);
    return [round(much * outward[0]), round(much * outward[1])];
  }).flat();
  return { ...deformation, keys: [{ at: 0, moves }], phase: 0 };
}

/**
 * Sides that look to the side have more room on a stage; of equal ones it is that which lies highest and most to the
 * right.
 */
function longestSide(hull: readonly Point[]): { middle: Point; outward: Point } {
  let best = { middle: [0.5, 0.5] as Point, outward: [0, 1] as Point };
  let most = Number.NEGATIVE_INFINITY;
  hull.forEach(([x0, y0], i) => {
    const [x1, y1] = hull[(i + 1) % hull.length] ?? [x0, y0];
    const length = Math.hypot(x1 - x0, y1 - y0);
    const rank = 0.4 * length + Math.abs(y1 - y0) + 1e-3 * (x0 + x1 + y0 + y1);
    if (!(length > 0) || rank <= most) return;
    most = rank;
    // Counter-clockwise: the outside is on the right.
    best = {
      middle: [(x0 + x1) / 2, (y0 + y1) / 2],
      outward: [(y1 - y0) / length, (x0 - x1) / length],
    };
  });
  return best;
}
