import { signal } from "@preact/signals";

/** Whether the grid lies over the picture: both its lines and its handles. */
export const gridShown = signal(true);
