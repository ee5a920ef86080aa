/** What a dust of two equal pieces would measure. */

/** Moran's dimension of two pieces of scale `size` that do not meet: 2 · size^D = 1. */
export function dustDimension(size: number): number {
  return Math.log(2) / -Math.log(size);
}

/** From here on a dust would have more than the dimension of the plane; up to there less than that of a line. */
export const PLANE = Math.SQRT1_2;
export const LINE = 0.5;
