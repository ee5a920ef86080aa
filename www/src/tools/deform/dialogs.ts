import { signal } from "@preact/signals";

/** Whether the gallery is open. */
export const gallery = signal(false);
