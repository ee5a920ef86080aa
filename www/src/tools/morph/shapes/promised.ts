/** A pair that the gallery says holds by another way: that way is offered as soon as it is found. */
import { effect, signal } from "@preact/signals";
import { along, plan, publish } from "#compute/results";
import { scene } from "#document/scene";
import type { Scene } from "#wasm/api";

type Pair = Pick<Scene, "a" | "b">;

/** The presets of the pair; none where nothing was promised. */
const promised = signal<string | null>(null);

const idsOf = ({ a, b }: Pair): string | null =>
  a.preset === undefined || b.preset === undefined ? null : `${a.preset} ${b.preset}`;

/** What was chosen last, and whether the gallery has said that another way holds. */
export function promise(pair: Pair, otherway: boolean): void {
  promised.value = otherway ? idsOf(pair) : null;
}

/** Whether it was said of this pair, as it came from the gallery, on the way that is found for it. */
export function isPromised(now: Scene): boolean {
  const { correspondence, turns, path } = now;
  const plain = correspondence.length === 0 && turns.length === 0 && path.kind === "auto";
  return plain && promised.value !== null && promised.value === idsOf(now);
}

/** It was offered, once. */
export function kept(): void {
  promised.value = null;
}

// Until it is found, what breaks on the way that stands there is no fault of this pair.
effect(() => {
  const breaks = plan.value?.holds === false && along.value?.breaks.length !== 0;
  publish.promised.value = breaks && isPromised(scene.value);
});
