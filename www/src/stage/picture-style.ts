import { computed, effect, type ReadonlySignal } from "@preact/signals";
import { pieceColours, ranked } from "#document/colours";
import { ranks, selection } from "#document/morph";
import { ownWeights } from "#document/own-weights";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import type { RenderStyle } from "#wasm/core";

const colouring = computed(() => scene.value.colouring);

const colours = computed(() => {
  const all = pieceColours(dark.value ? "dark" : "light");
  const editing = selection.value;
  // A shape that is edited has its maps in their own order, and each of them the colour that it has in the morph.
  return editing ? ranked(all, ranks[editing.target].value) : all;
});

/** How the stage is coloured: the same object while only the moment changes. */
export const stageStyle: ReadonlySignal<RenderStyle> = computed(() => ({
  colouring: colouring.value,
  palette: colours.value,
  lightGround: !dark.value,
}));

/** How often the chaos game takes each map, where that is to be seen: without a density no pixel hangs on it. */
export const shownWeights: ReadonlySignal<number[] | undefined> = computed(() =>
  colouring.value === "density" ? ownWeights.value : undefined,
);

effect(() => {
  const { a, b } = scene.value;
  if (a.weights ?? b.weights) void import("#document/weights");
});
