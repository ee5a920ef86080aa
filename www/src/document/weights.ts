/** What the weights of both shapes are on the way between them. The maps do not hang on them. */
import { computed, effect } from "@preact/signals";
import { weighted } from "#geometry/maps/weighted";
import type { Uv } from "#geometry/path";
import type { MorphOptions, Pairing } from "#wasm/api";
import { frond } from "#wasm/core";
import { here, locusView, morphOptions, ownWeights, pairing, selection, uv } from "./morph";
import { scene } from "./scene";

const a = computed(() => scene.value.a);
const b = computed(() => scene.value.b);
const t = computed(() => scene.value.t);
const morphing = computed(() => (scene.value.tool ?? "morph") === "morph");

type Shares = readonly number[][] | undefined;

/** Those of the maps of both ends, brought to the same number; nothing where neither has any. */
const shares = computed((): Shares => {
  const [from, to] = [a.value, b.value];
  if (!from.weights && !to.weights) return undefined;
  try {
    return frond.pair(weighted(from.maps, from.weights), weighted(to.maps, to.weights)).probabilities;
  } catch {
    return undefined;
  }
});

/** The weights at any parameter. */
export function weightsAt(at: Uv, options: MorphOptions = morphOptions.value): number[] | undefined {
  return weightsBetween(pairing.value, shares.value, at, options);
}

/** The shares of both ends as they are now: what `weightsBetween` is given. */
export const sharesNow = (): Shares => shares.peek();

/** The weights of a pair that is given, whatever the document has become. */
export function weightsBetween(
  { from, to }: Pairing,
  [p, q]: Shares = [],
  [u, v]: Uv,
  options: MorphOptions,
): number[] | undefined {
  if (!p || !q) return undefined;
  return frond.interpolate(weighted(from, p), weighted(to, q), { ...options, u, v }).probabilities;
}

/** Those of the maps that the stage shows. */
function now(): number[] | undefined {
  if (!shares.value) return undefined;
  const end = morphing.value ? selection.value?.target : { 0: "a" as const, 1: "b" as const }[t.value];
  if (end) return (end === "a" ? a : b).value.weights;
  if (!morphing.value) return weightsAt(uv.value);
  return locusView.value.family === "morph" ? weightsAt(here.value) : undefined;
}

effect(() => {
  ownWeights.value = now();
});
