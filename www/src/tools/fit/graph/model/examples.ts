/** Graphs of our own making to try the search on. */
import type { Graph } from "#wasm/api";
import * as messages from "../messages";
import { TABLE_1 } from "../printed";
import { evaluator } from "./model";

export interface Example {
  id: string;
  name: string;
  /** One sentence. */
  about: string;
  /** Coarse and fine feature points that suit it. */
  features: readonly [coarse: number, fine: number];
  smoothing: number;
  /** t0, x0, t1, x1, .. */
  make: () => Float64Array<ArrayBuffer>;
}

/** A function through points, each piece a copy of the whole. */
function through(knots: readonly (readonly [t: number, x: number])[], factors: readonly number[]): Graph {
  const [first, last] = [knots[0] ?? [0, 0], knots.at(-1) ?? [1, 0]];
  const long = last[0] - first[0];
  const pieces = factors.map((c, i): Graph["pieces"][number] => {
    const [from, to] = [knots[i] ?? first, knots[i + 1] ?? last];
    const a = (to[0] - from[0]) / long;
    const b = (to[1] - from[1] - c * (last[1] - first[1])) / long;
    const e = from[1] - c * first[1] - b * first[0];
    return { map: [a, b, c, from[0] - a * first[0], e], domain: [first[0], last[0]] };
  });
  return { kind: "fif", pieces };
}

/** A ridge, before noise is laid over it. */
const RIDGE = through(
  [
    [0, 0.1],
    [0.25, 0.7],
    [0.5, 0.3],
    [1, 0.6],
  ],
  [0.4, -0.35, 0.55],
);

function sampled(
  graph: Graph,
  [from, to]: readonly [number, number],
  count: number,
): Float64Array<ArrayBuffer> {
  const at = evaluator(graph);
  const points = new Float64Array(2 * count);
  for (let i = 0; i < count; i++) {
    const t = from + ((to - from) * i) / (count - 1);
    points[2 * i] = t;
    points[2 * i + 1] = at(t);
  }
  return points;
}

/** Height of the arrowhead curve from corner to corner round a third one, given the heights of corners. */
export function arrowhead(t: number, corners: readonly [number, number, number], depth = 30): number {
  let [a, b, c] = corners;
  let share = t;
  for (let level = 0; level < depth; level++) {
    const third = Math.min(2, Math.max(0, Math.floor(3 * share)));
    share = 3 * share - third;
    const [p, q, middle] = [(a + c) / 2, (c + b) / 2, (a + b) / 2];
    if (third === 0) [b, c] = [p, middle];
    else if (third === 1) [a, b] = [p, q];
    else [a, c] = [q, middle];
  }
  return a + share * (b - a);
}

/** From 0 to 1, the same numbers each time. */
function noiseFrom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let z = Math.imul(state ^ (state >>> 15), state | 1);
    z ^= z + Math.imul(z ^ (z >>> 7), z | 61);
    return ((z ^ (z >>> 14)) >>> 0) / 4294967296;
  };
}

function noisy(points: Float64Array<ArrayBuffer>, size: number, seed: number): Float64Array<ArrayBuffer> {
  const next = noiseFrom(seed);
  // Twelve even numbers come near enough to a bell.
  const bell = () => Array.from({ length: 12 }, next).reduce((sum, x) => sum + x, -6);
  return points.map((x, i) => (i % 2 === 0 ? x : x + size * bell()));
}

export const EXAMPLES: readonly Example[] = [
  {
    id: "table1",
    name: messages.twoMapsTable1,
    about: messages.testInPaperFunction,
    features: [65, 129],
    smoothing: 0,
    make: () => sampled(TABLE_1, [-1, 1], 2049),
  },
  {
    id: "hidden",
    name: messages.hiddenVariableFig4,
    about: messages.projectionCurveInSpace,
    features: [55, 163],
    smoothing: 0,
    make: () => {
      const count = 1459;
      const points = new Float64Array(2 * count);
      for (let i = 0; i < count; i++) {
        const t = i / (count - 1);
        points[2 * i] = t;
        points[2 * i + 1] = arrowhead(t, [0, 1, 0.5]);
      }
      return points;
    },
  },
  {
    id: "noisy",
    name: messages.measuredWithNoise,
    about: messages.threeMapsUnderNoise,
    features: [65, 129],
    smoothing: 0.002,
    make: () => noisy(sampled(RIDGE, [0, 1], 4097), 0.01, 7),
  },
];
