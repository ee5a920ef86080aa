/**
 * What Cochran, Hart & Flynn print in their tables. A map is [a, b, c, d, e]: t' = a t + d, x' = b t + c x + e (eq 1).
 */

import { TABLE_1 as TABLE_1_GRAPH, TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";

export type ShearMap = [a: number, b: number, c: number, d: number, e: number];

export interface Piece {
  map: ShearMap;
  domain: [alpha: number, beta: number];
}

/** Table 1, on [-1, 1]. */
export const TABLE_1: readonly Piece[] = TABLE_1_GRAPH.pieces;

/** Table 2. */
export const TABLE_2: readonly { hits: number; map: ShearMap }[] = [
  { hits: 43_657, map: [0.496, 0.746, 0.496, -0.488, 0.251] },
  { hits: 24_587, map: [0.496, -0.201, -0.6, 0.488, 0.211] },
  { hits: 5637, map: [0.496, -0.911, 0.496, 0.016, 0.512] },
  { hits: 5373, map: [0.496, 1.337, -0.42, -0.992, -0.571] },
  { hits: 3251, map: [0.496, 1.456, -0.6, 0.016, 1.607] },
];

/** The candidate maps that the paper counts for Table 2 and for Figure 5. */
export const COUNTED = { table2: 38_519_585, figure5: 31_032_427 };

/** Table 3. */
export const TABLE_3: readonly Piece[] = [
  { map: [-0.333, 0, -0.5, 0.222, 0.375], domain: [0.278, 0.667] },
  { map: [0.333, 0, -0.5, 0.074, 0.563], domain: [0.167, 0.5] },
  { map: [0.333, 0, 0.5, 0.185, 0.063], domain: [0.167, 0.444] },
  { map: [0.333, 0, 0.5, 0.333, 0.25], domain: [0, 1] },
  { map: [-0.333, 0, -0.5, 0.815, 0.938], domain: [0.167, 0.444] },
  { map: [-0.333, 0, 0.5, 0.926, 0.437], domain: [0.167, 0.5] },
  { map: [0.333, 0, 0.5, 0.778, 0.625], domain: [0.277, 0.667] },
];

/** The fractions that Table 3 rounds. */
export const TABLE_3_EXACT: readonly Piece[] = TABLE_3_GRAPH.pieces;

/** Figure 6. */
export const FIGURE_6 = { worst: 0.0858, meanSquare: 0.00018 };

/** Where a map takes a point. */
export function applied([a, b, c, d, e]: ShearMap, [t, x]: readonly [number, number]): [number, number] {
  return [a * t + d, b * t + c * x + e];
}

/** p after q. */
export function after([a, b, c, d, e]: ShearMap, q: ShearMap): ShearMap {
  return [a * q[0], b * q[0] + c * q[1], c * q[2], a * q[3] + d, b * q[3] + c * q[4] + e];
}

export function inverse([a, b, c, d, e]: ShearMap): ShearMap {
  return [1 / a, -b / (a * c), 1 / c, -d / a, ((b * d) / a - e) / c];
}
