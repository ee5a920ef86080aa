/** Fractal functions through points at even distances (Barnsley 1986). */
import type { MapRow } from "#wasm/api";

export interface Rough {
  /** The heights of the points, from left to right. */
  heights: readonly number[];
  /** For each piece between two points, by how much it is a flattened copy of the whole: between -1 and 1. */
  factors: readonly number[];
}

/** The maps that carry the whole curve to each of its pieces: 1/N as wide, `factor` times as tall, and sheared. */
export function mapsOf({ heights, factors }: Rough): MapRow[] {
  const count = factors.length;
  const [first = 0, last = 0] = [heights[0], heights[count]];
  return factors.map((factor, i): MapRow => {
    const [from = 0, to = 0] = [heights[i], heights[i + 1]];
    return [1 / count, 0, to - from - factor * (last - first), factor, i / count, from - factor * first];
  });
}

/** The heights of the curve at N^`level` even steps, each level made from the one before: at 1 those of the points. */
export function samples(curve: Rough, level: number): Float64Array {
  const maps = mapsOf(curve);
  let now = Float64Array.from(curve.heights);
  for (let k = 1; k < level; k++) {
    const steps = now.length - 1;
    const next = new Float64Array(maps.length * steps + 1);
    for (const [i, [, , slope, factor, , lift]] of maps.entries())
      for (let j = 0; j <= steps; j++)
        next[i * steps + j] = slope * (j / steps) + factor * (now[j] ?? 0) + lift;
    now = next;
  }
  return now;
}

/** All ups and downs from sample to sample together. */
export function climb(heights: Float64Array): number {
  let sum = 0;
  for (let i = 1; i < heights.length; i++) sum += Math.abs((heights[i] ?? 0) - (heights[i - 1] ?? 0));
  return sum;
}

/** Whether all points lie on one straight line: then so does the curve, whatever its factors. */
export function isStraight(heights: readonly number[]): boolean {
  const count = heights.length - 1;
  const [first = 0, last = 0] = [heights[0], heights[count]];
  return heights.every((height, i) => Math.abs(height - first - ((last - first) * i) / count) < 1e-9);
}

/** The sizes of the factors, summed. */
export const total = (factors: readonly number[]) =>
  factors.reduce((sum, factor) => sum + Math.abs(factor), 0);

/** The dimension by boxes: 1 + log (|s_1| + .. + |s_N|) / log N where that sum is above 1, else 1. */
export function dimension({ heights, factors }: Rough): number {
  const sum = total(factors);
  // Sums of hundredths may round to a little above 1.
  if (isStraight(heights) || sum <= 1 + 1e-9) return 1;
  return 1 + Math.log(sum) / Math.log(factors.length);
}

/** A dimension of about a quarter more than a line: what hundredths of a roughness can reach. */
export function isQuarter(curve: Rough): boolean {
  return Math.abs(dimension(curve) - 1.25) < 0.02;
}

/** Whether a curve of four pieces has a dimension above 1.2 with as many straight pieces as there can be: two. */
export function spares(curve: Rough): boolean {
  return dimension(curve) > 1.2 && curve.factors.filter((factor) => factor === 0).length === 2;
}
