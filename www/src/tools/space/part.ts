import { signal } from "@preact/signals";

export type Part = "shape" | "bend" | "morph" | "light" | "time";

/** Which part of the panel is open: a way of looking, no part of the document. */
export const part = signal<Part>("shape");
