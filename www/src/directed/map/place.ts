/** Between parameters and places of the square that shows them. */
import { BOUNDS } from "#compute/locus/job";
import type { Uv } from "#geometry/path";

const { u0, u1, v0, v1 } = BOUNDS;

/** Where parameters lie, in parts of the square from its upper left corner. */
export const place = ([u, v]: Uv): Uv => [(u - u0) / (u1 - u0), (v1 - v) / (v1 - v0)];

/** The moment of the straight way that is nearest to a place. */
export function momentNear([x, y]: Uv): number {
  const [u, v] = [u0 + x * (u1 - u0), v1 - y * (v1 - v0)];
  return Math.min(1, Math.max(0, (u + v) / 2));
}
