/** Graphs of fractal functions as the figures show them. */
import type { Graph } from "#wasm/api";
import { applied, type Piece } from "./printed-tables";

/** The part of t that a piece covers. */
export function rangeOfPiece({ map: [a, , , d], domain: [alpha, beta] }: Graph["pieces"][number]) {
  const ends = [a * alpha + d, a * beta + d] as const;
  return { from: Math.min(...ends), to: Math.max(...ends) };
}

/**
 * Samples (t0, x0, t1, ..) parted where the pieces meet, in the order of the pieces; a point where two meet is in both.
 */
export function byPiece(graph: Graph, samples: Float64Array): Float64Array[] {
  const [first, last] = [samples[0] ?? 0, samples[samples.length - 2] ?? 1];
  const near = 1e-9 * (last - first);
  return graph.pieces.map((piece) => {
    const { from, to } = rangeOfPiece(piece);
    const count = samples.length / 2;
    let begin = 0;
    while (begin < count && (samples[2 * begin] ?? 0) < from - near) begin++;
    let end = begin;
    while (end < count && (samples[2 * end] ?? 0) <= to + near) end++;
    return samples.subarray(2 * begin, 2 * end);
  });
}

/** The least scale with round marks that holds all heights, and at least the given one. */
export function rangeOf(lines: readonly ArrayLike<number>[], least: { min: number; max: number }) {
  let { min, max } = least;
  for (const line of lines) {
    for (let i = 1; i < line.length; i += 2) {
      const x = line[i] ?? 0;
      if (x < min) min = x;
      if (x > max) max = x;
    }
  }
  const step = stepFor(max - min);
  min = min < least.min ? Math.floor(min / step) * step : min;
  max = max > least.max ? Math.ceil(max / step) * step : max;
  const ticks: number[] = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; k++) {
    ticks.push(Number((k * step).toPrecision(12)));
  }
  return { min, max, ticks };
}

/** 1, 2 or 5 times a power of ten, so that four to eight marks fit. */
export function stepFor(span: number): number {
  if (!(span > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(span / 4));
  const times = span / 4 / power;
  return power * (times >= 5 ? 5 : times >= 2 ? 2 : 1);
}

/**
 * The paper's ideal feature points of a function of maps that copy the whole: their fixed points, and the images of
 * these under all compositions of so many maps, from left to right. Where two pieces should meet, the right one counts.
 */
export function fixedPointImages(pieces: readonly Piece[], depth: number): [t: number, x: number][] {
  let points = pieces.map(({ map: [a, b, c, d, e] }): [number, number] => {
    const t = d / (1 - a);
    return [t, (b * t + e) / (1 - c)];
  });
  for (let level = 0; level < depth; level++) {
    const images = pieces.flatMap(({ map }) => points.map((point) => applied(map, point)));
    points = images.filter(([t], i) => !images.some(([other], k) => k > i && Math.abs(other - t) < 1e-9));
  }
  return points.sort((p, q) => p[0] - q[0]);
}
