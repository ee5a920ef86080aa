/** The paper's Fig 1 for two maps on a line, as it is printed, with all that it looks at kept to be drawn. */

export interface Round {
  /** n of the bound, from 0. */
  n: number;
  /** The finite sets that stand for the two pieces, each in rising order. */
  pieces: [number[], number[]];
  /** The least distance between them; d_1 and d_2 are the same. */
  distance: number;
  /** The two points that are so near. */
  nearest: [number, number];
  /** No point of a piece is farther than this from the point that stands for it: s^(n+1) R. */
  reach: number;
  /** 2 s^(n+1) R. */
  bound: number;
  /** The distance is more than the bound: no points of the pieces themselves can meet. */
  apart: boolean;
}

/**
 * Runs the test on {r x, r x + 1 - r}, 0 < r < 1: s = r, and R = 1 since the attractor lies in [0, 1]. It starts from
 * the origin, and ends with the round that proves something or after `iterations`.
 */
export function barnsley(r: number, iterations: number): Round[] {
  const rounds: Round[] = [];
  let points = [0];
  for (let n = 0; n < iterations; n++) {
    const first = points.map((x) => r * x);
    const second = points.map((x) => r * x + 1 - r);
    const nearest = nearestPair(first, second);
    const distance = Math.abs(nearest[1] - nearest[0]);
    const reach = r ** (n + 1);
    const apart = distance > 2 * reach * (1 + 1e-12);
    rounds.push({ n, pieces: [first, second], distance, nearest, reach, bound: 2 * reach, apart });
    if (apart) break;
    points = merge(first, second);
  }
  return rounds;
}

/** The two nearest points of two rising lists. */
export function nearestPair(p: readonly number[], q: readonly number[]): [number, number] {
  let best: [number, number] = [p[0] ?? Number.NaN, q[0] ?? Number.NaN];
  for (let i = 0, j = 0; i < p.length && j < q.length; ) {
    const [x, y] = [p[i] ?? 0, q[j] ?? 0];
    if (Math.abs(y - x) < Math.abs(best[1] - best[0])) best = [x, y];
    if (x < y) i++;
    else j++;
  }
  return best;
}

function merge(p: readonly number[], q: readonly number[]): number[] {
  return [...p, ...q].sort((x, y) => x - y);
}

/** Intervals of half-width `reach` about points in rising order, those that meet made one. */
export function cover(points: readonly number[], reach: number): [number, number][] {
  const intervals: [number, number][] = [];
  for (const x of points) {
    const last = intervals.at(-1);
    if (last && x - reach <= last[1]) last[1] = x + reach;
    else intervals.push([x - reach, x + reach]);
  }
  return intervals;
}

/** The intervals that two such lists have in common. */
export function common(p: readonly [number, number][], q: readonly [number, number][]): [number, number][] {
  const both: [number, number][] = [];
  for (let i = 0, j = 0; i < p.length && j < q.length; ) {
    const [a = 0, b = 0] = p[i] ?? [];
    const [c = 0, d = 0] = q[j] ?? [];
    if (Math.max(a, c) <= Math.min(b, d)) both.push([Math.max(a, c), Math.min(b, d)]);
    if (b < d) i++;
    else j++;
  }
  return both;
}
