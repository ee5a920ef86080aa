import { signal } from "@preact/signals";
import type { End } from "./changes";

/** The end whose shape is being chosen; null while the gallery is closed. */
export const gallery = signal<End | null>(null);

/** Whether the list of pairs is open, and in it the other ways to match, and the ways across. */
export const pairsOpen = signal(false);
export const matchingOpen = signal(false);
export const routesOpen = signal(false);

/** Opens the other ways to match, and goes there. */
export function openMatching(): void {
  pairsOpen.value = true;
  matchingOpen.value = true;
  goTo("matching");
}

/** Opens the ways across, and goes there. */
export function openRoutes(): void {
  pairsOpen.value = true;
  routesOpen.value = true;
  goTo("routes");
}

function goTo(id: string): void {
  // It is drawn after the state has changed.
  requestAnimationFrame(() => {
    const summary = document.getElementById(id)?.querySelector<HTMLElement>("summary");
    const panel = summary?.closest<HTMLElement>(".side");
    if (!summary || !panel) return;
    summary.focus({ preventScroll: true });
    panel.scrollTop += summary.getBoundingClientRect().top - panel.getBoundingClientRect().top;
  });
}
