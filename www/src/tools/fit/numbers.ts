/** How many numbers a fit may spend, on a slider where twice as many are always as far away. */
import { LEAST_NUMBERS, MOST_NUMBERS } from "./work/fitting";

export const LOW = Math.log2(LEAST_NUMBERS);
export const HIGH = Math.log2(MOST_NUMBERS);

export function placeOf(numbers: number): number {
  return Math.log2(numbers);
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
