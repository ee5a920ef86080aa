/** How often the chaos game takes each map of a shape. The shape itself does not hang on it. */
import type { Ifs, MapRow, Shape } from "#wasm/api";

/** Maps as a system, with their weights where these are said. */
export const weighted = (maps: MapRow[], weights: number[] | undefined): Ifs =>
  weights ? { maps, probabilities: weights } : { maps };

/** A shape with these weights, or without any; itself where they are its own. */
export function withWeights(shape: Shape, weights: number[] | undefined): Shape {
  if (shape.weights === weights) return shape;
  const { weights: _, ...rest } = shape;
  return weights ? { ...rest, weights } : rest;
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
