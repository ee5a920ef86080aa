/** Walks along a circle of the plane of s: where on it the shape is proved in one piece, and where dust. */
import type { Complex } from "../../kit/locus/set-m";

/** The circle of the picture, and the one that is asked about: both lie between ½ and 0.7071. */
export const [SHOWN, ASKED] = [0.65, 0.68];
/** The part of the circle that is asked about, in degrees. */
export const [FROM, TO] = [65, 90];
/** How often it changes there, degree by degree. */
export const CHANGES = 3;

export function onCircle(size: number, degrees: number): Complex {
  const angle = (degrees * Math.PI) / 180;
  return [size * Math.cos(angle), size * Math.sin(angle)];
}

/** How often a row of states changes. */
export function changes(states: readonly string[]): number {
  return states.filter((state, i) => i > 0 && state !== states[i - 1]).length;
}
