/** Parts of the document, so that what shows a part is not drawn again at every moment of a morph that plays. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { scene } from "#document/scene";
import type { Colouring, Mode, PathKind, Shape } from "#wasm/api";
import type { End } from "./changes";

export const shapes: Record<End, ReadonlySignal<Shape>> = {
  a: computed(() => scene.value.a),
  b: computed(() => scene.value.b),
};
export const pathKind: ReadonlySignal<PathKind> = computed(() => scene.value.path.kind);
export const mode: ReadonlySignal<Mode> = computed(() => scene.value.mode);
export const compare: ReadonlySignal<boolean> = computed(() => scene.value.compare);
export const colouring: ReadonlySignal<Colouring> = computed(() => scene.value.colouring);
export const correspondence: ReadonlySignal<number[]> = computed(() => scene.value.correspondence);
export const turns: ReadonlySignal<number[]> = computed(() => scene.value.turns);
