/** Which part of a plane of parameters is looked at, how finely, and at what resolution. */
import type { Bounds, LocusView } from "#wasm/api";
import * as messages from "../messages";

/** Steps between the samples of a whole plane: 253 samples a side, both ends included. */
export const CELLS = 252;

export type Family = LocusView["family"];

/** What is seen at zoom 1: of a morph [-1, 2] in u and v, of a polygon family the square around the unit circle. */
const HOMES: Record<Family, Bounds> = {
  morph: { u0: -1, v0: -1, u1: 2, v1: 2 },
  polygon: { u0: -1, v0: -1, u1: 1, v1: 1 },
};

export const homeOf = (family: Family): Bounds => HOMES[family];

/** Nearer than this, neighbouring pixels would be the same number. */
export const MOST_ZOOM = 1e13;
/** The finest level: its samples are at least six steps of f64 apart. */
export const DEEPEST = 43;

/** The narrowest gap that f64 can tell from none. */
export const LEAST_EPSILON = 1e-14;

/** Samples are laid on grids that double: level 0 has 252 steps over the whole plane, the next 504, .. */
export function levelOf(zoom: number): number {
  return Math.min(DEEPEST, Math.max(0, Math.round(Math.log2(zoom))));
}

/**
 * How near pieces must come to count as touching, relative to the shape: what 600 pixels resolve at home, and finer in
 * proportion as one looks nearer.
 */
export function epsilonOf(level: number): number {
  return Math.max(LEAST_EPSILON, 2 ** -level / 600);
}

/** The number of samples along a side of a level: a whole number, exact up to the deepest. */
export const samplesAt = (level: number): number => CELLS * 2 ** level + 1;

/** The parameter of sample `k` of a level, along the axis from `low` to `high`. */
export function parameterAt(low: number, high: number, level: number, k: number): number {
  // Multiplied first, as in the program: then 0 and 1 are met exactly.
  return low + ((high - low) * k) / (CELLS * 2 ** level);
}

/** The rectangle that a view shows. */
export function windowOf({ family, x, y, zoom }: LocusView): Bounds {
  const home = homeOf(family);
  if (zoom === 1) return home;
  const half = (home.u1 - home.u0) / (2 * zoom);
  return { u0: x - half, v0: y - half, u1: x + half, v1: y + half };
}

/** The same view within what there is to see: nothing beyond home, nothing beyond f64. Only for finite numbers. */
export function clampedView(view: LocusView): LocusView {
  const home = homeOf(view.family);
  const zoom = Math.min(MOST_ZOOM, Math.max(1, view.zoom));
  const half = (home.u1 - home.u0) / (2 * zoom);
  const within = (at: number, low: number, high: number) =>
    zoom === 1 ? (low + high) / 2 : Math.min(high - half, Math.max(low + half, at));
  return {
    ...view,
    zoom,
    x: within(view.x, home.u0, home.u1),
    y: within(view.y, home.v0, home.v1),
    w: view.family === "morph" ? Math.min(1, Math.max(-1, view.w)) : 0,
    sides: view.family === "morph" ? 2 : Math.min(64, Math.max(2, Math.round(view.sides))),
  };
}

/** What is wrong with a view that came from outside, in words; null for one that can be shown. */
export function viewProblem({ family, sides, x, y, zoom, w, at }: LocusView): string | null {
  const numbers = [sides, x, y, zoom, w, ...(at ?? [])];
  if (!numbers.every((n) => n === undefined || Number.isFinite(n))) return messages.containsInvalidNumbers;
  if (!(zoom > 0)) return messages.windowEmpty;
  const { u0, v0, u1, v1 } = homeOf(family);
  const slack = 1e-9;
  if (x < u0 - slack || x > u1 + slack || y < v0 - slack || y > v1 + slack) return messages.tooFarOut;
  return null;
}
