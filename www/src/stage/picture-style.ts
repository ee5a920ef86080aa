import { computed, effect, type ReadonlySignal } from "@preact/signals";
import { ownWeights, shownColours } from "#document/morph";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import type { RenderStyle } from "#wasm/core";

const colouring = computed(() => scene.value.colouring);

const colours = computed(() => shownColours(dark.value ? "dark" : "light"));

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
