/** Which part of the plane is seen: its middle, and how wide it is. */
import { HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";

/** Of the triangle around a piece: its lower left corner and its side. The whole has side 1. */
export interface Triangle {
  x: number;
  y: number;
  side: number;
}

export const WHOLE: Triangle = { x: 0, y: 0, side: 1 };

export interface View {
  x: number;
  y: number;
  width: number;
}

/** So much wider than a piece is what is seen of it. */
const ROOM = 1.25;

export function viewOf({ x, y, side }: Triangle): View {
  return { x: x + side / 2, y: y + (side * HEIGHT) / 2, width: ROOM * side };
}

/** From one view to another: the width by equal factors, the middle so that what is in both stays in a line. */
export function between(from: View, to: View, part: number): View {
  if (part >= 1) return to;
  const width = from.width * (to.width / from.width) ** part;
  const share =
    Math.abs(to.width - from.width) < 1e-12 ? part : (from.width - width) / (from.width - to.width);
  return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y), width };
}

const CORNERS: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];

function partOf({ x, y, side }: Triangle, letter: number): Triangle {
  const [u, v] = CORNERS[letter] ?? [0, 0];
  return { x: x + (side / 2) * u, y: y + (side / 2) * v, side: side / 2 };
}

/** The triangle around the piece that some letters lead to, from 0. */
export function triangleOf(letters: readonly number[]): Triangle {
  return letters.reduce(partOf, WHOLE);
}

/** Where the name of a piece stands. */
export function middleOf({ x, y, side }: Triangle): Point {
  return [x + side / 2, y + (side * HEIGHT) / 3];
}

/** Which part of a piece a point is in, by the triangle around it; null outside and in the middle. */
export function partAt(letters: readonly number[], [x, y]: Point): number | null {
  const piece = triangleOf(letters);
  const found = CORNERS.findIndex((_, letter) => {
    const part = partOf(piece, letter);
    const up = (y - part.y) / (part.side * HEIGHT);
    const across = (x - part.x) / part.side - up / 2;
    return up >= 0 && across >= 0 && across + up <= 1;
  });
  return found < 0 ? null : found;
}

export interface Small extends Triangle {
  /** The letters of the piece that it lies in, as far as they were asked for. */
  letters: readonly number[];
}

/** The small triangles that a view is drawn with: no side above `least`, none that is not seen. */
export function trianglesIn(view: View, least: number, keep: number): Small[] {
  const found: Small[] = [];
  const half = view.width / 2;
  const stack: Small[] = [{ ...WHOLE, letters: [] }];
  for (let here = stack.pop(); here; here = stack.pop()) {
    const { x, y, side, letters } = here;
    const seen =
      x < view.x + half && x + side > view.x - half && y < view.y + half && y + side * HEIGHT > view.y - half;
    if (!seen) continue;
    if (side <= least) {
      found.push(here);
      continue;
    }
    for (const letter of CORNERS.keys()) {
      const deeper = letters.length < keep ? [...letters, letter] : letters;
      stack.push({ ...partOf(here, letter), letters: deeper });
    }
  }
  return found;
}
