/** A run of the index buffer: points of the chaos game, ready to be plotted one after the other. */
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import { Collisions, windowOf } from "./collisions";

export const MOST_POINTS = 3000;
export const SEED = 1;
export const MARGIN = 0.05;

/** Points of the chaos game, each map as likely as any other, as the paper has it. */
function gamePoints(maps: MapRow[], points: number) {
  return frond.attractor({ maps, probabilities: maps.map(() => 1) }, { points, seed: SEED });
}

export function startRun(maps: MapRow[], size: number, points = MOST_POINTS): Collisions {
  const { min, max } = frond.bounds({ maps });
  return new Collisions(size, windowOf(min, max, MARGIN), gamePoints(maps, points));
}
