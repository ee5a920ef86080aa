/** A polygon family in motion: s goes along a curve of its own plane. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { locusWindow } from "#compute/results";
import { whilePlaying } from "#document/frames";
import { here } from "#document/morph";
import type { Uv } from "#geometry/path";
import { type Stretch, stateNear, stretches } from "#geometry/states";
import { pickPoint, setView, sides, view } from "../view/view";
import { courseOf, placeOf, pointAt } from "./course";

/** The curve that s goes along. */
const along = computed(() => courseOf(sides.value));

/** Where the picture's s is on it. */
export const place: ReadonlySignal<number> = computed(() => placeOf(here.value, along.value));

/** Points of it, evenly spaced. */
export const curve: ReadonlySignal<readonly Uv[]> = computed(() =>
  Array.from({ length: SAMPLES }, (_, k) => pointAt(here.value, along.value, k / (SAMPLES - 1))),
);

const going = signal(false);
export const orbiting: ReadonlySignal<boolean> = going;

/** Seconds once round, or out to the end. */
const SECONDS = 12;
let way = 1;

/** s while it moves: rounding of what the document keeps would add up. */
let exact: Uv = [0, 0];

function step(dt: number): void {
  if (view.peek().family !== "polygon") {
    going.value = false;
    return;
  }
  let next = placeOf(exact, along.peek()) + (way * dt) / SECONDS;
  if (along.peek() === "round") next -= Math.floor(next);
  else if (next >= 1 || next <= LEAST) {
    way = next >= 1 ? -1 : 1;
    next = Math.min(1, Math.max(LEAST, next));
  }
  exact = pointAt(exact, along.peek(), next);
  // As the moment of the morph: no step of undo.
  setView({ at: exact });
}

/** Where there is no turn left, the ray would be lost. */
const LEAST = 0.02;

whilePlaying(going, step, () => {
  going.value = false;
});

export function toggleOrbit(): void {
  exact = here.peek();
  way = 1;
  going.value = !going.peek();
}

/** So fine is s kept that the circle does not drift. */
const FINE = 1e6;

/** By hand: what plays stops. */
export function orbitTo(to: number): void {
  going.value = false;
  const least = along.peek() === "ray" ? LEAST : 0;
  pickPoint(pointAt(here.peek(), along.peek(), Math.min(1, Math.max(least, to))), "orbit", FINE);
}

/** Samples along the curve. */
const SAMPLES = 361;

/** Stretches of it where the shape is in pieces, as far as the map is known. */
export const orbitBreaks: ReadonlySignal<readonly Stretch[]> = computed(() => {
  const pyramid = locusWindow.value?.pyramid;
  if (pyramid?.family !== "polygon") return [];
  const field = pyramid.read({ u0: -1, v0: -1, u1: 1, v1: 1 }, 1);
  return stretches(curve.value.map((point) => stateNear(field, point)));
});
