/** What becomes of the weights of a file. */
import { areaShares } from "#document/area-shares";
import type { ImportedSystem } from "#wasm/api";
import * as messages from "./messages";

/** The weights of a system of the plane where they say more than its areas do, which stand for weights without them. */
export function weightsOf({ dimension, maps, probabilities }: ImportedSystem): number[] | undefined {
  if (dimension === 3 || probabilities?.length !== maps.length) return undefined;
  const sum = probabilities.reduce((all, weight) => all + weight, 0);
  const areas = areaShares(maps);
  const alike = probabilities.every((weight, i) => Math.abs(weight / sum - (areas[i] ?? 0)) < ROUNDED);
  return sum > 0 && !alike ? probabilities : undefined;
}

/** Files give weights with few digits. */
const ROUNDED = 0.006;

export function weightsWords(system: ImportedSystem): string[] {
  if (weightsOf(system)) return [messages.weightsKeptChooseColour];
  const { dimension, probabilities = [] } = system;
  const uneven = probabilities.some((weight) => weight !== probabilities[0]);
  return dimension === 3 && uneven ? [messages.weightsNotKeptSpace] : [];
}
