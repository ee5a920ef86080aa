/** The map in the place of the stage, and the shape in its corner. */
import { type ReadonlySignal, signal, useSignalEffect } from "@preact/signals";
import { detail } from "#compute/locus/detail";
import { notify } from "#document/notice";
import { listenForEscape } from "#ui/escape";
import * as messages from "../messages";

/** A way of looking, no part of the document. */
export const large = signal(false);

export const toggleLarge = (): void => {
  large.value = !large.value;
};

const filling = signal(false);
/** Whether the map has the whole screen. */
export const full: ReadonlySignal<boolean> = filling;

/** The map over the whole screen, and back. Where the browser refuses, the map is large, and that is said. */
export async function toggleFull(): Promise<void> {
  if (document.fullscreenElement) {
    await document.exitFullscreen();
    return;
  }
  large.value = true;
  try {
    await document.documentElement.requestFullscreen();
  } catch {
    notify({
      kind: "info",
      text: messages.thisBrowserDoesNot,
    });
  }
}

/** Pixels a side for which the samples of the map in its panel are enough. */
const PANEL_PIXELS = 307;

/** So much of a doubling is let be: three samples for every four pixels are fine enough. */
const LET_BE = 0.15;

/**
 * How much finer than in the panel the map is sampled when it is so many device pixels wide: about a sample for each
 * pixel, as long as the page can paint so many while it is moved.
 */
export function detailFor(pixels: number): 1 | 2 | 4 {
  const times = Math.max(0, Math.ceil(Math.log2(Math.max(1, pixels / PANEL_PIXELS)) - LET_BE));
  return ([1, 2, 4] as const)[Math.min(2, times)] ?? 1;
}

/** While the map is on the page: the layout follows, and Escape brings the stage back. */
export function useLarge(): void {
  useSignalEffect(() => {
    if (!large.value) return;
    const root = document.documentElement;
    root.dataset["largeMap"] = "";
    const measure = () => {
      const width = document.querySelector(".locus-square")?.clientWidth ?? 0;
      detail.value = detailFor(width * (globalThis.devicePixelRatio || 1));
    };
    measure();
    addEventListener("resize", measure);
    const turned = () => {
      const now = document.fullscreenElement !== null;
      filling.value = now;
      root.toggleAttribute("data-full-map", now);
    };
    turned();
    document.addEventListener("fullscreenchange", turned);
    const stop = listenForEscape(() => {
      large.value = false;
    });
    return () => {
      delete root.dataset["largeMap"];
      document.removeEventListener("fullscreenchange", turned);
      filling.value = false;
      root.removeAttribute("data-full-map");
      if (document.fullscreenElement) void document.exitFullscreen();
      detail.value = 1;
      removeEventListener("resize", measure);
      stop();
    };
  });
}
