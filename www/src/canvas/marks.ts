import { computed, type ReadonlySignal, signal } from "@preact/signals";

/** Whether the panel with the evidence for the verdict is open. */
export const evidenceOpen = signal(false);

/** Whether the evidence stays on the picture when the panel is closed. */
export const evidenceKept = signal(false);

/** Whether what holds the pieces together, or apart, is drawn over the picture. */
export const evidenceMarked: ReadonlySignal<boolean> = computed(
  () => evidenceOpen.value || evidenceKept.value,
);
