/** The chaos game, one throw at a time, on a triangle whose corners are 1, 2 and 3. */
import { hash } from "#geometry/maps/orbit";
import { HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";

export const CORNERS: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];

/** Where the first point lies: in the middle, as unlucky as can be. */
export const START: Point = [0.5, HEIGHT / 3];

/** A game on its way. Going back is starting anew. */
export class Throws {
  readonly points: Point[] = [START];
  /** The corner that each point but the first was thrown towards. */
  readonly corners: number[] = [];
  /** How many points have fallen into the middle triangle. */
  inMiddle = 0;

  get count(): number {
    return this.corners.length;
  }

  get here(): Point {
    return this.points.at(-1) ?? START;
  }

  /** Half of the way to a corner. */
  throwTo(corner: number): void {
    const [x, y] = this.here;
    const [u, v] = CORNERS[corner] ?? START;
    const next: Point = [(x + u) / 2, (y + v) / 2];
    this.points.push(next);
    this.corners.push(corner);
    if (isInMiddle(next)) this.inMiddle++;
  }

  /** So many throws at random; the same at every try. */
  roll(count: number): void {
    for (let i = 0; i < count; i++) this.throwTo(hash(this.count) % 3);
  }
}

/** The weights of the three corners at a point: they sum to 1, and 1, 0, 0 is the first corner. */
export function weights([x, y]: Point): [number, number, number] {
  const third = y / HEIGHT;
  const second = x - third / 2;
  return [1 - second - third, second, third];
}

/** Strictly inside the triangle between the middles of the sides. */
export function isInMiddle(point: Point): boolean {
  return weights(point).every((weight) => weight < 0.5 - 1e-12);
}

/** The empty triangles, as three corners each: the middle one, those of the halves, and so on for some levels. */
export function holes(levels: number): Point[][] {
  const mid = (p: Point, q: Point): Point => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
  const found: Point[][] = [];
  let wholes: Point[][] = [[...CORNERS]];
  for (let level = 0; level < levels; level++) {
    const next: Point[][] = [];
    for (const [a = START, b = START, c = START] of wholes) {
      const [ab, bc, ca] = [mid(a, b), mid(b, c), mid(c, a)];
      found.push([ab, bc, ca]);
      next.push([a, ab, ca], [ab, b, bc], [ca, bc, c]);
    }
    wholes = next;
  }
  return found;
}

/** Piece 3 of piece 2, from 0: what one is to throw into, and with how many throws at most. */
export const TARGET: readonly number[] = [1, 2];
export const MOST_AIMED = 4;

/** Where throws have led: the last one is the first digit of the piece that the mark is in. */
export function landed(corners: readonly number[]): "none" | "there" | "large" | "turned" | "elsewhere" {
  const [last, before] = [corners.at(-1), corners.at(-2)];
  if (last === undefined) return "none";
  const [large, small] = TARGET;
  if (last === large) return before === small ? "there" : "large";
  return last === small && before === large ? "turned" : "elsewhere";
}
