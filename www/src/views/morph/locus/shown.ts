import { computed, type ReadonlySignal } from "@preact/signals";
import { STATE } from "../../../engine/breaks";
import type { Field } from "../../../engine/pyramid";
import { locusWindow } from "../../../engine/results";
import type { Uv } from "../../../state/path";
import { shownWindow, view } from "./view";

/**
 * What is known of the window that is shown, read anew for every picture: coarser samples stand in for those that are not
 * there yet, so that moving about never leaves it blank. Null before anything is known of the plane.
 */
export const shownField: ReadonlySignal<Field | null> = computed(() => {
  const { pyramid } = locusWindow.value ?? {};
  const { family, zoom } = view.value;
  return pyramid?.family === family ? pyramid.read(shownWindow.value, zoom) : null;
});

/** The nearest sample of the window to a parameter: its state and its gap. Null beyond the window. */
export function sampleAt([u, v]: Uv): { state: number; gap: number } | null {
  const field = shownField.value;
  if (!field) return null;
  const { width, height, bounds } = field;
  const x = Math.round(((u - bounds.u0) / (bounds.u1 - bounds.u0)) * (width - 1));
  const y = Math.round(((v - bounds.v0) / (bounds.v1 - bounds.v0)) * (height - 1));
  if (!(x >= 0 && y >= 0 && x < width && y < height)) return null;
  return { state: field.state[y * width + x] ?? STATE.pending, gap: field.gap[y * width + x] ?? Number.NaN };
}
