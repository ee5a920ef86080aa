/** The seven maps of Table 3, and how far the function they make is from the one they were found for. */
import type { Graph } from "#wasm/api";
import { heightsAlong, TOP } from "./arrowhead";
import { rangeOfPiece } from "./graphs";
import type { Piece } from "./printed-tables";

/** Levels of the function of Figure 4 at whose steps it is measured: 2187 steps. */
const MEASURED_DEPTH = 7;
/** Copies of copies; each halves what is not known. */
const LEVELS = 60;

/** A function of pieces at t. What falls into a slit between pieces, or out of a domain, takes the nearest there is. */
export function valueAt(pieces: readonly Piece[], t: number): number {
  let at = t;
  let factor = 1;
  let value = 0;
  for (let level = 0; level < LEVELS; level++) {
    const piece = nearest(pieces, at);
    if (!piece) return Number.NaN;
    const [a, b, c, d, e] = piece.map;
    const source = Math.min(piece.domain[1], Math.max(piece.domain[0], (at - d) / a));
    value += factor * (b * source + e);
    factor *= c;
    at = source;
  }
  return value;
}

function nearest(pieces: readonly Piece[], t: number): Piece | undefined {
  let best: Piece | undefined;
  let least = Number.POSITIVE_INFINITY;
  for (const piece of pieces) {
    const { from, to } = rangeOfPiece(piece);
    const off = Math.max(from - t, t - to, 0);
    if (off < least) [best, least] = [piece, off];
  }
  return best;
}

export interface Misses {
  worst: number;
  meanSquare: number;
  /** Where the worst one is. */
  at: number;
  /** t0, miss0, t1, miss1, .. */
  all: Float64Array;
}

/** How far the function of pieces is from that of Figure 4. */
export function missesOf(pieces: readonly Piece[]): Misses {
  const known = heightsAlong(MEASURED_DEPTH, TOP);
  const all = new Float64Array(known.length);
  const misses: Misses = { worst: 0, meanSquare: 0, at: 0, all };
  const count = known.length / 2;
  for (let i = 0; i < count; i++) {
    const t = known[2 * i] ?? 0;
    const miss = Math.abs(valueAt(pieces, t) - (known[2 * i + 1] ?? 0));
    all[2 * i] = t;
    all[2 * i + 1] = miss;
    misses.meanSquare += miss ** 2 / count;
    if (miss > misses.worst) [misses.worst, misses.at] = [miss, t];
  }
  return misses;
}

/** The ends of pieces, from left to right, each once. */
export function breakpoints(graph: Graph): number[] {
  const ends = graph.pieces.flatMap((piece) => {
    const { from, to } = rangeOfPiece(piece);
    return [from, to];
  });
  return ends.sort((p, q) => p - q).filter((t, i, all) => i === 0 || t - (all[i - 1] ?? 0) > 1e-6);
}

/** A fraction of small numbers in words, where the value is one. */
export function fractionWords(value: number): string {
  for (let below = 1; below <= 243; below++) {
    const above = value * below;
    if (Math.abs(above - Math.round(above)) < 1e-6) {
      return below === 1 ? `${Math.round(above)}` : `${Math.round(above)}/${below}`;
    }
  }
  return value.toFixed(4);
}
