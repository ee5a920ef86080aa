import { signal } from "@preact/signals";

/** Whether the list of keyboard shortcuts is open: each tool has its own. */
export const help = signal(false);
