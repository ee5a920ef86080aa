import { computed, type ReadonlySignal } from "@preact/signals";
import { pieceColours } from "#document/colours";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import type { RenderStyle } from "#wasm/core";

const colouring = computed(() => scene.value.colouring);

/** How the stage is coloured. */
export const stageStyle: ReadonlySignal<RenderStyle> = computed(() => ({
  colouring: colouring.value,
  palette: pieceColours(dark.value ? "dark" : "light"),
}));
