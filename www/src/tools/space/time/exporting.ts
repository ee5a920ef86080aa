/** What the time line knows of a film in the making: the rest is loaded when it is asked for. */
import { signal } from "@preact/signals";

/** Whether the dialog is open. */
export const exportOpen = signal(false);

/** How far the film is that is being made, 0 to 1; null while none is. */
export const exportProgress = signal<number | null>(null);

export function openExport(): void {
  exportOpen.value = true;
}
