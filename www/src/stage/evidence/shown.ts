/** Whether evidence is shown, and where its panel stands. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";

/** Whether the panel with the evidence for the verdict is open. */
export const evidenceOpen = signal(false);

/** Whether the evidence stays on the picture when the panel is closed. */
export const evidenceKept = signal(false);

/** The panel stands beside the picture where there is room for both; elsewhere it lies below, or over it. */
const PANEL_WIDTH = 384;
const LEAST_WIDTH = 820;

/** What the panel takes from the left of a stage, in CSS pixels. */
export function panelInset(stageWidth: number): number {
  return evidenceOpen.value && stageWidth >= LEAST_WIDTH ? PANEL_WIDTH : 0;
}

/** Whether what holds the pieces together, or apart, is drawn over the picture. */
export const evidenceMarked: ReadonlySignal<boolean> = computed(
  () => evidenceOpen.value || evidenceKept.value,
);
