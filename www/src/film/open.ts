/** What the page knows of the dialogs of films and pictures: the rest is loaded when it is asked for. */
import { computed, signal } from "@preact/signals";
import type { Command } from "#ui/commands";
import * as messages from "./messages";

/** Which is open. */
export const exportOpen = signal<"film" | "picture" | "mesh" | "share" | "publish" | "recent" | null>(null);

/** How far the film is that is being made, 0 to 1; null while none is. */
export const filmProgress = signal<number | null>(null);

/** Whether a film was made while its dialog was closed, and has not been seen yet. */
export const filmUnseen = signal(false);

/** Whether there is more to say of a film than its closed dialog says. */
export const filmTold = computed(
  () => exportOpen.value !== "film" && (filmProgress.value !== null || filmUnseen.value),
);

export function openFilm(): void {
  filmUnseen.value = false;
  exportOpen.value = "film";
}

export function openPicture(): void {
  exportOpen.value = "picture";
}

export function openMesh(): void {
  exportOpen.value = "mesh";
}

export function openShare(): void {
  exportOpen.value = "share";
}

export function openRecent(): void {
  exportOpen.value = "recent";
}

/** In every tool in which something moves. */
export const FILM: Command = {
  id: "film",
  label: messages.film,
  group: messages.everywhere,
  keys: ["X"],
  run: openFilm,
};
