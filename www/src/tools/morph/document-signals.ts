/** Parts of the document, so that what shows a part is not drawn again at every moment of a morph that plays. */

import { computed, type ReadonlySignal } from "@preact/signals";
import { ownColours } from "#document/colours";
import { current, ownWeights } from "#document/morph";
import { scene } from "#document/scene";
import type { NamedMaps } from "#ui/files/exporting";
import type { Colouring, Mode, PathKind, Shape } from "#wasm/api";
import type { End } from "./edits";
import * as messages from "./messages";

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

/** The maps of both ends, and of the moment where that is neither. */
export function namedMaps(): NamedMaps[] {
  const { a, b, t } = scene.peek();
  const palette = ownColours(scene.peek());
  const ends = [
    { label: "A", name: a.name, maps: a.maps, weights: a.weights, palette },
    { label: "B", name: b.name, maps: b.maps, weights: b.weights, palette },
  ];
  if (t === 0 || t === 1) return ends;
  const name = messages.fromToAt(a.name, b.name, t.toFixed(2));
  return [
    ...ends,
    { label: `t = ${t.toFixed(2)}`, name, maps: current.peek(), weights: ownWeights.peek(), palette },
  ];
}
