import { signal } from "@preact/signals";

/**
 * How often the chaos game takes each map that the stage shows, where the document says so. `weights.ts` keeps it, once
 * a document has some: most have none.
 */
export const ownWeights = signal<number[] | undefined>(undefined);
