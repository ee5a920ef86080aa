/** How the locus is looked at, and what hands and keys do to that. */

import { computed, effect, type ReadonlySignal, untracked } from "@preact/signals";
import { detail } from "#compute/locus/detail";
import type { Field } from "#compute/locus/pyramid";
import { clampedView, epsilonOf, type Family, levelOf, viewProblem, windowOf } from "#compute/locus/window";
import { locusWindow } from "#compute/results";
import { locusView, uv } from "#document/morph";
import { notify } from "#document/notice";
import { playing } from "#document/playback";
import { reducedMotion } from "#document/preferences";
import { edit, replace, scene } from "#document/scene";
import { fixed } from "#format/numbers";
import type { Uv } from "#geometry/path";
import type { Bounds, LocusView } from "#wasm/api";
import * as messages from "../messages";
import { between, digitsOf, kept, roundedTo, wholeOf, zoomed } from "./geometry";

/** What is shown: the document's view, or all of its plane where that cannot be shown. */
export const view: ReadonlySignal<LocusView> = computed(() => {
  const asked = locusView.value;
  return viewProblem(asked) === null ? clampedView(asked) : wholeOf(asked.family);
});

export const shownWindow: ReadonlySignal<Bounds> = computed(() => windowOf(view.value));
export const epsilon: ReadonlySignal<number> = computed(() =>
  epsilonOf(levelOf(view.value.zoom * detail.value)),
);
export const family: ReadonlySignal<Family> = computed(() => view.value.family);
export const sides: ReadonlySignal<number> = computed(() => view.value.sides);
/** The parameter that was picked off the path, if any. */
export const picked: ReadonlySignal<Uv | null> = computed(() => view.value.at ?? null);

/** A parameter of the window that is shown, with as many digits as it needs. */
export const inDigits = (x: number): string => fixed(x, digitsOf(view.value.zoom));

const isWhole = ({ family: kind, zoom, w, at }: LocusView) =>
  kind === "morph" && zoom === 1 && w === 0 && at === undefined;

/** The view as it belongs in the document: what is seen anyway is left out. */
function kindOf(next: LocusView): { locus?: LocusView } {
  return isWhole(next) ? {} : { locus: next };
}

function withView(next: LocusView) {
  const { locus: _, ...rest } = scene.peek();
  return { ...rest, ...kindOf(roundedTo(clampedView(next))) };
}

/** Looks elsewhere: no step of undo. */
export function setView(change: Partial<LocusView>): void {
  const next = { ...view.peek(), ...change };
  if (viewProblem({ ...next, x: 0, y: 0 }) === null) replace(withView(next));
}

/** Moves by parts of the window, to the right and up. */
export function panBy(x: number, y: number): void {
  stopFlying();
  const now = view.peek();
  const { u0, v0, u1, v1 } = shownWindow.peek();
  setView({ x: now.x + x * (u1 - u0), y: now.y + y * (v1 - v0) });
}

/** Nearer by a factor; what is at a place of the square, in parts from its left and its bottom, stays there. */
export function zoomBy(factor: number, [px, py]: readonly [number, number] = [0.5, 0.5]): void {
  stopFlying();
  setView(zoomed(view.peek(), factor, [px, py]));
}

export function goHome(): void {
  const { family: kind, sides: n } = view.peek();
  const { x, y, zoom } = wholeOf(kind, n);
  fly({ x, y, zoom });
}

const lastViews = new Map<string, LocusView>();
const memory = ({ family: kind, sides: n }: LocusView) => (kind === "morph" ? kind : `${kind}-${n}`);
// However a plane is left, it is found again as it was looked at; what was picked on it, where it is a family's.
effect(() => {
  const { at, ...rest } = view.value;
  lastViews.set(memory(view.value), at && rest.family === "polygon" ? { ...rest, at } : rest);
});

/** Another plane, as it was last looked at. */
export function setPlane(kind: Family, n: number): void {
  stopFlying();
  const next = wholeOf(kind, n);
  replace(withView(lastViews.get(memory(next)) ?? next));
}

/** Takes a point as what the picture shows, as exactly as a zoom needs: a step of undo. */
export function pickPoint(point: Uv, gesture?: string, zoom = view.peek().zoom): void {
  const { family: kind, w } = view.peek();
  const [u, v] = [kept(point[0], zoom), kept(point[1], zoom)];
  const third = kind === "morph" ? (point[2] ?? w) : 0;
  const at: Uv = third === 0 ? [u, v] : [u, v, third];
  edit(() => withView({ ...view.peek(), at }), gesture === undefined ? {} : { gesture });
}

/** What is left of a view when nothing is picked any more: a family has no path to go back to but the morph's. */
function unpicked(now: LocusView): LocusView {
  if (now.family !== "morph") return lastViews.get("morph") ?? wholeOf("morph");
  const { at: _, ...rest } = now;
  return rest;
}

export function backToPath(): void {
  edit(() => withView(unpicked(view.peek())));
}

// Who moves in time, or plays, wants to see the path.
{
  let t = scene.peek().t;
  let at = locusView.peek();
  effect(() => {
    const now = scene.value.t;
    const going = playing.value;
    const seen = locusView.value;
    const moved = now !== t && seen === at;
    t = now;
    at = seen;
    if (!(moved || going) || (seen.at === undefined && seen.family === "morph")) return;
    untracked(() => replace(withView(unpicked(view.peek()))));
  });
}

// Whoever lets a point go may leave a view that says nothing.
effect(() => {
  const { locus, ...rest } = scene.value;
  if (locus && isWhole(locus) && viewProblem(locus) === null) untracked(() => replace(rest));
});

// What a link asks for and cannot be shown is said, once, and not kept.
effect(() => {
  const problem = viewProblem(locusView.value);
  if (problem === null) return;
  untracked(() => {
    const { at, ...home } = wholeOf(locusView.peek().family);
    replace(withView(home));
    notify({
      kind: "info",
      text: messages.viewProblem(problem),
    });
  });
});

const FLIGHT_MS = 700;
let flight = 0;

export function stopFlying(): void {
  if (flight) cancelAnimationFrame(flight);
  flight = 0;
}

/** Goes there, in one movement; at once where motion is not wanted. */
export function fly(target: { x: number; y: number; zoom: number }): void {
  stopFlying();
  const from = view.peek();
  const to = clampedView({ ...from, ...target });
  if (reducedMotion.peek() || document.hidden) {
    setView(target);
    return;
  }
  let began: number | null = null;
  const step = (now: number) => {
    began ??= now;
    const s = Math.min(1, (now - began) / FLIGHT_MS);
    const { x, y, zoom } = between(from, to, s * s * (3 - 2 * s));
    setView({ x, y, zoom });
    flight = s < 1 ? requestAnimationFrame(step) : 0;
  };
  flight = requestAnimationFrame(step);
}

/** How far the present point of the path lies off the slice that is shown. */
export const offSlice: ReadonlySignal<number> = computed(() => {
  const [, , w = 0] = picked.value ?? uv.value;
  return view.value.family === "morph" ? w - view.value.w : 0;
});

/**
 * What is known of the window that is shown, read anew for every picture: coarser samples stand in for those that are
 * not there yet, so that moving about never leaves it blank. Null before anything is known of the plane.
 */
export const shownField: ReadonlySignal<Field | null> = computed(() => {
  const { pyramid } = locusWindow.value ?? {};
  const { family, zoom } = view.value;
  return pyramid?.family === family ? pyramid.read(shownWindow.value, zoom * detail.value) : null;
});
