/** What the page knows of the dialog of films: the rest is loaded when it is asked for. */
import { signal } from "@preact/signals";
import type { Command } from "#ui/commands";

/** Whether it is open. */
export const filmOpen = signal(false);

/** How far the film is that is being made, 0 to 1; null while none is. */
export const filmProgress = signal<number | null>(null);

export function openFilm(): void {
  filmOpen.value = true;
}

/** In every tool in which something moves. */
export const FILM: Command = {
  id: "film",
  label: "Film of what moves",
  group: "Everywhere",
  keys: ["X"],
  run: openFilm,
};
