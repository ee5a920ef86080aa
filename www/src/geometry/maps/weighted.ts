/** How often the chaos game takes each map of a shape. The shape itself does not hang on it. */
import type { Ifs, MapRow, Shape } from "#wasm/api";
import { carriedExact } from "./exact";
import { sameMaps } from "./same-maps";

/** Maps as a system, with their weights where these are said. */
export const weighted = (maps: MapRow[], weights: number[] | undefined): Ifs =>
  weights ? { maps, probabilities: weights } : { maps };

/** A shape with these weights, or without any; itself where they are its own. */
export function withWeights(shape: Shape, weights: number[] | undefined): Shape {
  if (shape.weights === weights) return shape;
  const { weights: _, ...rest } = shape;
  return weights ? { ...rest, weights } : rest;
}

/** Whether two shapes are made by the same maps, as often but for rounding. */
export function sameWeighted(p: Shape, q: Shape): boolean {
  const near = (x: number, y: number | undefined) => y !== undefined && Math.abs(x - y) <= SAME_WEIGHT * x;
  const [weights, others] = [p.weights ?? [], q.weights ?? []];
  const alike = weights.length === others.length && weights.every((x, i) => near(x, others[i]));
  return alike && sameMaps(p.maps, q.maps);
}

/** How far the same weight may differ from itself, in proportion. */
const SAME_WEIGHT = 1e-9;
/** Digits of a weight: enough for its share, and none that only rounding has made. */
const WEIGHT_DIGITS = 12;

/** A shape made by other maps, and how probable these are; itself where they are its own. A sum of weights stays. */
export function remade(shape: Shape, maps: MapRow[], probabilities: readonly number[]): Shape {
  if (sameMaps(shape.maps, maps)) return shape;
  const { name, weights } = shape;
  const sum = weights?.reduce((all, weight) => all + weight, 0) ?? 0;
  const carried = weights && probabilities.map((p) => Number((p * sum).toPrecision(WEIGHT_DIGITS)));
  return withWeights(carriedExact(shape, name, maps), carried);
}

/**
 * The weights of maps that were made of others: a map that is still there keeps its own, one that was changed in its
 * place too, and a new one has what the others have on the average.
 */
export function carriedWeights(
  before: { maps: readonly MapRow[]; weights?: readonly number[] | undefined },
  maps: readonly MapRow[],
): number[] | undefined {
  const { weights } = before;
  if (!weights) return undefined;
  if (maps.length === before.maps.length) return [...weights];
  const mean = weights.reduce((sum, weight) => sum + weight, 0) / weights.length;
  const carried = maps.map((map) => weights[before.maps.indexOf(map)] ?? mean);
  // Where all that is left is never taken, weights say nothing.
  return carried.some((weight) => weight > 0) ? carried : undefined;
}
