/** The locus on the graphics card, where there is one that is faster than the workers. */
import { createLocusCompute, type LocusCompute, timeLocus } from "../../pkg/renderer.js";
import type { Locus, LocusOptions, MapRow } from "./api";
import { toError } from "./protocol";

export interface Ends {
  from: MapRow[];
  to: MapRow[];
  options: LocusOptions;
}

/** Decides a whole locus on the processor, for the comparison. */
export type OnProcessor = (ends: Ends) => Promise<unknown>;

let card: LocusCompute | null = null;
let asked = false;
let busy = false;

export const hasCard = (): boolean => card !== null;

/**
 * Looks for a card once and times it against the processor. `software` takes one that is none, and untimed: for trying this
 * where there is no card.
 */
export async function findCard(processor: OnProcessor, software = false): Promise<void> {
  if (asked) return;
  asked = true;
  const found = await createLocusCompute({ software });
  if (!found) return;
  const onProcessor = (from: { maps: MapRow[] }, to: { maps: MapRow[] }, options: LocusOptions) =>
    processor({ from: from.maps, to: to.maps, options });
  try {
    if (software || (await timeLocus(found, onProcessor)).faster === "gpu") card = found;
  } catch {
    // A card that cannot do it is no card.
  }
  if (card !== found) found.free();
}

/**
 * A whole locus; samples that single precision cannot tell have state 3. Null where the card has no answer: none is there,
 * it is still at work, or the locus is not for it.
 */
export async function locusByCard({ from, to, options }: Ends): Promise<Locus | null> {
  const mine = card;
  if (!mine || busy) return null;
  busy = true;
  try {
    return await mine.run({ maps: from }, { maps: to }, options);
  } catch (problem) {
    // Too many maps or too fine is the workers' to do; after anything else the card is not asked again.
    if (!toError(problem).code.startsWith("single-") && card === mine) {
      card = null;
      mine.free();
    }
    return null;
  } finally {
    busy = false;
  }
}
