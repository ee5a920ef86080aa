/** Graph-directed shapes: what the morph works on in place of two systems, where the document has them. */
import { computed, effect, type ReadonlySignal } from "@preact/signals";
import type { Box } from "#geometry/boxes";
import type { Scene } from "#wasm/api";
import { directedTask } from "#workers/directed/client";
import type { Moment, Way } from "#workers/directed/moment";
import { isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { scene } from "../scene";
import { directedBoxAt } from "../stand-in";
import { halfTurnsOf } from "./changes";

/** The shapes of the document. */
export const directedShapes: ReadonlySignal<NonNullable<Scene["directed"]> | null> = computed(
  () => scene.value.directed ?? null,
);

const mode = computed(() => scene.value.mode);

/** The way between them; null where there is none. */
export const directedWay: ReadonlySignal<Way | null> = computed(() => {
  const now = directedShapes.value;
  return now && { from: now.a, to: now.b, mode: mode.value, ...halfTurnsOf(now) };
});

/** The present moment of it. */
export const directedMoment: ReadonlySignal<Moment | null> = computed(() => {
  const way = directedWay.value;
  return way && { ...way, t: scene.value.t };
});

/** Moments whose boxes are asked for. */
const LOOKS = 13;

// Where it lies is found by a worker, and known a little later.
effect(() => {
  const way = directedWay.value;
  if (!way) {
    directedBoxAt.value = null;
    return;
  }
  const end = new AbortController();
  directedTask("boxes", { way, looks: LOOKS }, { signal: end.signal }).then(
    (boxes) => {
      directedBoxAt.value = (t) => nearest(boxes, t);
    },
    (problem) => {
      if (!isStopped(problem)) {
        notify({ kind: "error", text: messages.statesNotLoaded(wordsOf(problem)) });
        directedBoxAt.value ??= () => null;
      }
    },
  );
  return () => end.abort();
});

const nearest = (boxes: readonly (Box | null)[], t: number): Box | null =>
  boxes[Math.round(t * (boxes.length - 1))] ?? null;
