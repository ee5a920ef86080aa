/** The locus on the graphics card, where there is one that is faster than the workers. */
import { createLocusCompute, hasGraphicsCard, type LocusCompute, timeLocus } from "../../pkg/renderer.js";
import type { FamilyOptions, Locus, LocusOptions, MapRow } from "./api";
import { toError } from "./error";
import { lacksWebGpu } from "./webgpu";

export type { LocusCompute };

export interface Ends {
  from: MapRow[];
  to: MapRow[];
  options: LocusOptions;
}

/** Maps over a plane of parameters: of a morph, or of a family of polygons. */
export type Plane = Ends | { sides: number; options: FamilyOptions };

/** What a card says. Samples that single precision cannot tell are undecided. */
export type ByCard = Locus & { milliseconds: number };

/** Decides a whole locus on the processor, for the comparison. */
type OnProcessor = (ends: Ends) => Promise<unknown>;

/** Whether it is worth while to open a card, which is known at once. */
export const mayHaveCard = async (software: boolean): Promise<boolean> =>
  !(await lacksWebGpu()) && (software || (await hasGraphicsCard()));

/** A card, if there is one. `software` takes one that the processor stands in for: for trying this without a card. */
export async function openCard(software: boolean): Promise<LocusCompute | null> {
  return (await createLocusCompute({ software })) ?? null;
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

/** Fewer samples tell little of how fast a card is. */
const LEAST_SAMPLES = 10_000;
/** How much slower a card is taken to be after each answer that was slower: it has more to do than this. */
const SLOWER = 1.5;

/** One card for all who ask, one after the other. */
export class CardQueue {
  /** About how many milliseconds a sample takes, when the card has nothing else to do. */
  pace = 1e-3;
  readonly #lost: () => void;
  #card: LocusCompute | null;
  #turn: Promise<unknown> = Promise.resolve();

  /** `lost` is told when the card has failed, and is not asked again. */
  constructor(card: LocusCompute, lost: () => void) {
    this.#card = card;
    this.#lost = lost;
  }

  /**
   * The samples of a plane; null where the card has no answer: the plane is not for it, it has failed, or they are no
   * longer `wanted` when it would begin.
   */
  ask(plane: Plane, wanted: () => boolean): Promise<ByCard | null> {
    const answer = this.#turn.then(() => (wanted() ? this.#run(plane) : null));
    this.#turn = answer;
    return answer;
  }

  async #run(plane: Plane): Promise<ByCard | null> {
    const card = this.#card;
    if (!card) return null;
    try {
      const found = await ("sides" in plane
        ? card.runFamily({ sides: plane.sides }, plane.options)
        : card.run({ maps: plane.from }, { maps: plane.to }, plane.options));
      const samples = found.width * found.height;
      if (samples >= LEAST_SAMPLES) this.pace = Math.min(SLOWER * this.pace, found.milliseconds / samples);
      return found;
    } catch (problem) {
      // Too many maps or too fine is the workers' to do; after anything else the card is not asked again.
      if (!toError(problem).code.startsWith("single-")) {
        this.#card = null;
        card.free();
        this.#lost();
      }
      return null;
    }
  }
}
