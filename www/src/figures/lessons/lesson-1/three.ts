/** Three pieces in the corners of a triangle of side 1: how near they come to each other, by their scales. */

export type Scales = readonly [number, number, number];
export type Pair = readonly [i: number, j: number];
export const PAIRS: readonly Pair[] = [
  [0, 1],
  [0, 2],
  [1, 2],
];

/** Rounding of scales in hundredths or thousandths. */
const EXACT = 1e-9;

/**
 * How far two pieces are apart; below 0, how far they overlap on their side. Along the side they lie on, piece i
 * reaches as far as its scale from one corner, and piece j from the other; elsewhere they are no nearer.
 */
export function apart(scales: Scales, [i, j]: Pair): number {
  return 1 - (scales[i] ?? 0) - (scales[j] ?? 0);
}

/** Whether they touch in one point. */
export const touches = (scales: Scales, pair: Pair) => Math.abs(apart(scales, pair)) < EXACT;
export const meets = (scales: Scales, pair: Pair) => apart(scales, pair) < EXACT;

/** The widest step that cannot be avoided on a way over all pieces: the second shortest of the three. */
export function gapOf(scales: Scales): number {
  const [, second = 0] = PAIRS.map((pair) => Math.max(0, apart(scales, pair))).sort((p, q) => p - q);
  return second < EXACT ? 0 : second;
}
