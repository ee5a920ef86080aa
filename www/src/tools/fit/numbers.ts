/** How many numbers a fit may spend, on a slider where twice as many are always as far away. */
import { LEAST_NUMBERS, MOST_NUMBERS } from "./work/fitting";

export const LOW = Math.log2(LEAST_NUMBERS);
export const HIGH = Math.log2(MOST_NUMBERS);

export function placeOf(numbers: number): number {
  return Math.log2(numbers);
}

/** How many bytes a fit may take: as `crate/fit/src/spline/fitter.rs` has it. */
export const LEAST_BYTES = 32;
export const MOST_BYTES = 4000;
export const LOW_BYTES = Math.log2(LEAST_BYTES);
export const HIGH_BYTES = Math.log2(MOST_BYTES);

export function bytesAt(place: number): number {
  return Math.min(MOST_BYTES, Math.max(LEAST_BYTES, Math.round(2 ** place)));
}

/** Even, since a knot and a copy cost two each. */
export function numbersAt(place: number): number {
  const n = 2 * Math.round(2 ** place / 2);
  return Math.min(MOST_NUMBERS, Math.max(LEAST_NUMBERS, n));
}

/** What is asked for by hand: even, too. */
export function even(n: number): number {
  return 2 * Math.round(n / 2);
}
