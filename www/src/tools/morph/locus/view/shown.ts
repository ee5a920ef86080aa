import { computed, type ReadonlySignal } from "@preact/signals";
import { detail } from "#compute/locus/detail";
import type { Field } from "#compute/locus/pyramid";
import { locusWindow } from "#compute/results";
import { shownWindow, view } from "./view";

/**
 * What is known of the window that is shown, read anew for every picture: coarser samples stand in for those that are
 * not there yet, so that moving about never leaves it blank. Null before anything is known of the plane.
 */
export const shownField: ReadonlySignal<Field | null> = computed(() => {
  const { pyramid } = locusWindow.value ?? {};
  const { family, zoom } = view.value;
  return pyramid?.family === family ? pyramid.read(shownWindow.value, zoom * detail.value) : null;
});
