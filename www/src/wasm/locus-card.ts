/** The locus on the graphics card, where there is one that is faster than the workers. */
import { createLocusCompute, type LocusCompute, timeLocus } from "../../pkg/renderer.js";
import type { Locus, LocusOptions, MapRow } from "./api";
import { toError } from "./error";
import { lacksWebGpu } from "./webgpu";

export type { LocusCompute };

export interface Ends {
  from: MapRow[];
  to: MapRow[];
  options: LocusOptions;
}

/** Decides a whole locus on the processor, for the comparison. */
type OnProcessor = (ends: Ends) => Promise<unknown>;

let card: LocusCompute | null = null;
let busy = false;

export const hasCard = (): boolean => card !== null;

/** From here on loci are decided by this card. */
export function adoptCard(found: LocusCompute): void {
  card = found;
}

/** A card, if there is one. `software` takes one that the processor stands in for: for trying this without a card. */
export async function openCard(software: boolean): Promise<LocusCompute | null> {
  return (await lacksWebGpu()) ? null : ((await createLocusCompute({ software })) ?? null);
}

/** Times a card against the processor. */
export async function isFaster(found: LocusCompute, processor: OnProcessor): Promise<boolean> {
  const onProcessor = (from: { maps: MapRow[] }, to: { maps: MapRow[] }, options: LocusOptions) =>
    processor({ from: from.maps, to: to.maps, options });
  try {
    return (await timeLocus(found, onProcessor)).faster === "gpu";
  } catch {
    // A card that cannot do it is no card.
    return false;
  }
}

/**
 * A whole locus; samples that single precision cannot tell have state 3. Null where the card has no answer: none is
 * there, it is still at work, or the locus is not for it.
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
