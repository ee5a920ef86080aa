import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";

/**
 * How often the chaos game takes each map where a shape has no weights: in proportion to its area, as the renderer has
 * it. They sum to 1; without an attractor all are alike.
 */
export function areaShares(maps: MapRow[]): number[] {
  const alike = maps.map(() => 1 / maps.length);
  try {
    // A pair tells the shares of both where it is given those of one.
    return frond.pair({ maps }, { maps, probabilities: alike }).probabilities?.[0] ?? alike;
  } catch {
    return alike;
  }
}
