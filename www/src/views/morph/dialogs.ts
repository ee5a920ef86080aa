import { signal } from "@preact/signals";
import type { End } from "./changes";

/** The end whose shape is being chosen; null while the gallery is closed. */
export const gallery = signal<End | null>(null);

/** Whether the list of keyboard shortcuts is open. */
export const help = signal(false);
