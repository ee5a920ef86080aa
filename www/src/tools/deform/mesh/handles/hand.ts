import { signal } from "@preact/signals";

/** What a press beside all handles begins: moving the picture, pulling at the mesh there, or choosing handles. */
export type Hand = "move" | "pull" | "choose";

export const hand = signal<Hand>("move");
