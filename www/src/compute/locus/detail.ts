/** How finely the map of parameters is sampled. */
import { signal } from "@preact/signals";

/** Samples along a side for each that the map has in its panel: 1, 2 or 4. */
export const detail = signal<1 | 2 | 4>(1);
