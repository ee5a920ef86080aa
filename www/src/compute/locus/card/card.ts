/** What decides loci besides the workers, where a graphics card was found that is faster than they are. */
import type { LocusWork } from "../job";
import type { WindowWork } from "../window-job";

/**
 * Decides what single precision can tell, as long as it is `wanted`. The workers are to `begin` with what is left when
 * that takes long, and when it is done; then they may have begun before.
 */
export interface LocusCard {
  whole(work: LocusWork, wanted: () => boolean, begin: () => void): void;
  tiles(work: WindowWork, wanted: () => boolean, begin: () => void): void;
}

/** One, or none. */
export const locusCard: { found: LocusCard | null } = { found: null };
