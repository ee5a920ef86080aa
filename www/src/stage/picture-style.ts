import { computed, type ReadonlySignal } from "@preact/signals";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { palette } from "#style/palette";
import type { RenderStyle } from "#wasm/core";

const colouring = computed(() => scene.value.colouring);

/** How the stage is coloured. */
export const stageStyle: ReadonlySignal<RenderStyle> = computed(() => ({
  colouring: colouring.value,
  palette: palette(dark.value ? "dark" : "light"),
}));
