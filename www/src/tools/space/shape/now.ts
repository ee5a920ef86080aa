/** What the panel is about: the chosen object, as made and as it is now. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { chosen, IDENTITY, space, spaceFrame } from "#document/space/space";
import type { MapRow3, ShapeFacts3, SpaceObject } from "#wasm/api";
import { solid } from "#wasm/space";

/** The chosen object as the document has it. */
export const object: ReadonlySignal<SpaceObject | null> = computed(
  () => space.value?.objects[chosen.value] ?? null,
);

/** The maps it is made with, at this moment of the morph and of the time line. */
export const made: ReadonlySignal<MapRow3[]> = computed(
  () => spaceFrame.value?.objects[chosen.value]?.maps ?? object.value?.maps ?? [],
);

/** All that was done to it. */
export const moved: ReadonlySignal<MapRow3> = computed(
  () => spaceFrame.value?.objects[chosen.value]?.moved ?? object.value?.moved ?? IDENTITY,
);

/** Its parameters now. */
export const parameters: ReadonlySignal<MapRow3[]> = computed(
  () => spaceFrame.value?.objects[chosen.value]?.now ?? made.value,
);

const REST_MS = 150;
const last = signal<MapRow3[]>([]);

/** The parameters as they were when nothing had changed for a moment: for what takes longer than a frame. */
export const rested: ReadonlySignal<MapRow3[]> = last;

/** Keeps `rested` up to date. Returns the end of it. */
export function watchRest(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = effect(() => {
    const now = parameters.value;
    clearTimeout(timer);
    if (last.peek().length === 0) last.value = now;
    else timer = setTimeout(() => take(now), REST_MS);
  });
  return () => {
    stop();
    clearTimeout(timer);
  };
}

function take(now: MapRow3[]): void {
  // The same numbers again are no news.
  if (JSON.stringify(now) !== JSON.stringify(last.peek())) last.value = now;
}

/** What is to be said of it; null where it has no attractor. */
export const facts: ReadonlySignal<ShapeFacts3 | null> = computed(() => factsOf(rested.value));

export function factsOf(maps: MapRow3[]): ShapeFacts3 | null {
  if (maps.length === 0) return null;
  try {
    return solid.facts3(maps);
  } catch {
    return null;
  }
}
