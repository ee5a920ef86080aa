/** What is drawn on the stage of the fit. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { opened } from "../work/source";

/** Whether a picture is being cut out, or its outline fitted. */
export const step = signal<"cut" | "fit">("cut");

export const cutting: ReadonlySignal<boolean> = computed(() => opened.value !== null && step.value === "cut");

/** Whether the picture is drawn below the fit. */
export const photoShown = signal(true);
export const outlineShown = signal(true);
/** Knots of the fit, or the feature points of the paper's. */
export const knotsShown = signal(false);

/** While it is held, the outline is seen alone. */
export const comparing = signal(false);
