/** The map in the place of the stage, and the shape in its corner. */
import { signal, useSignalEffect } from "@preact/signals";
import { detail } from "#compute/locus/detail";
import { listenForEscape } from "#ui/escape";

/** A way of looking, no part of the document. */
export const large = signal(false);

export const toggleLarge = (): void => {
  large.value = !large.value;
};

/** Pixels a side for which the samples of the map in its panel are enough. */
const PANEL_PIXELS = 307;

/** How much finer than in the panel the map is sampled when it is so many device pixels wide. */
export function detailFor(pixels: number): 1 | 2 | 4 {
  const times = Math.round(Math.log2(Math.max(1, pixels / PANEL_PIXELS)));
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
    const stop = listenForEscape(() => {
      large.value = false;
    });
    return () => {
      delete root.dataset["largeMap"];
      detail.value = 1;
      removeEventListener("resize", measure);
      stop();
    };
  });
}
