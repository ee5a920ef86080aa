/** How the locus is looked at, and what hands and keys do to that. */
import { computed, effect, type ReadonlySignal, untracked } from "@preact/signals";
import type { Bounds, LocusView } from "../../../engine/api";
import {
  clampedView,
  epsilonOf,
  type Family,
  homeOf,
  levelOf,
  viewProblem,
  windowOf,
} from "../../../engine/window";
import { locusView, uv, WHOLE } from "../../../state/morph";
import { notify } from "../../../state/notice";
import type { Uv } from "../../../state/path";
import { playing } from "../../../state/playback";
import { reducedMotion } from "../../../state/preferences";
import { edit, replace, scene } from "../../../state/scene";
import { fixed } from "../../../ui/number";

/** All of a plane. */
export function wholeOf(family: Family, sides = 2): LocusView {
  const { u0, v0, u1, v1 } = homeOf(family);
  return { ...WHOLE, family, sides, x: (u0 + u1) / 2, y: (v0 + v1) / 2 };
}

/** What is shown: the document's view, or all of its plane where that cannot be shown. */
export const view: ReadonlySignal<LocusView> = computed(() => {
  const asked = locusView.value;
  return viewProblem(asked) === null ? clampedView(asked) : wholeOf(asked.family);
});

export const shownWindow: ReadonlySignal<Bounds> = computed(() => windowOf(view.value));
export const epsilon: ReadonlySignal<number> = computed(() => epsilonOf(levelOf(view.value.zoom)));
export const family: ReadonlySignal<Family> = computed(() => view.value.family);
export const sides: ReadonlySignal<number> = computed(() => view.value.sides);
/** The parameter that was picked off the path, if any. */
export const picked: ReadonlySignal<Uv | null> = computed(() => view.value.at ?? null);

/** Decimals that tell the pixels of a window apart, and some more for what is kept. */
export const digitsOf = (zoom: number): number => 2 + Math.ceil(Math.log10(Math.max(1, zoom)));
const kept = (x: number, zoom: number): number => Number(x.toFixed(Math.min(20, digitsOf(zoom) + 2))) || 0;

/** A parameter of the window that is shown, with as many digits as it needs. */
export const inDigits = (x: number): string => fixed(x, digitsOf(view.value.zoom));

/** Short in a link, and still finer than a pixel. */
export function roundedTo({ x, y, zoom, w, ...rest }: LocusView): LocusView {
  return { ...rest, x: kept(x, zoom), y: kept(y, zoom), zoom: Number(zoom.toPrecision(6)), w: kept(w, 100) };
}

/** The view as it belongs in the document: what is seen anyway is left out. */
function kindOf(next: LocusView): { locus?: LocusView } {
  const whole = next.family === "morph" && next.zoom === 1 && next.w === 0 && next.at === undefined;
  return whole ? {} : { locus: next };
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

/** The same, as a function of a view. */
export function zoomed(now: LocusView, factor: number, [px, py]: readonly [number, number]): LocusView {
  const zoom = clampedView({ ...now, zoom: now.zoom * factor }).zoom;
  const home = homeOf(now.family);
  // The middle moves by what the window loses on that side. Written so, it is exact for a factor of 1.
  const by = (home.u1 - home.u0) * (1 / now.zoom - 1 / zoom);
  return { ...now, zoom, x: now.x + (px - 0.5) * by, y: now.y + (py - 0.5) * by };
}

export function goHome(): void {
  const { family: kind, sides: n } = view.peek();
  const { x, y, zoom } = wholeOf(kind, n);
  fly({ x, y, zoom });
}

const lastViews = new Map<string, LocusView>();
const memory = ({ family: kind, sides: n }: LocusView) => (kind === "morph" ? kind : `${kind}-${n}`);

/** Another plane, as it was last looked at. */
export function setPlane(kind: Family, n: number): void {
  stopFlying();
  lastViews.set(memory(view.peek()), view.peek());
  const next = wholeOf(kind, n);
  replace(withView(lastViews.get(memory(next)) ?? next));
}

/** Takes a point as what the picture shows: a step of undo. */
export function pickPoint(point: Uv, gesture?: string): void {
  const { zoom, family: kind, w } = view.peek();
  const [u, v] = [kept(point[0], zoom), kept(point[1], zoom)];
  const third = kind === "morph" ? (point[2] ?? w) : 0;
  const at: Uv = third === 0 ? [u, v] : [u, v, third];
  edit(() => withView({ ...view.peek(), at }), gesture === undefined ? {} : { gesture });
}

/** What is left of a view when nothing is picked any more: a family has no path to go back to but the morph's. */
function unpicked(now: LocusView): LocusView {
  if (now.family !== "morph") {
    lastViews.set(memory(now), now);
    return lastViews.get("morph") ?? wholeOf("morph");
  }
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

// What a link asks for and cannot be shown is said, once, and not kept.
effect(() => {
  const problem = viewProblem(locusView.value);
  if (problem === null) return;
  untracked(() => {
    const { at, ...home } = wholeOf(locusView.peek().family);
    replace(withView(home));
    notify({
      kind: "info",
      text: `This view of the map cannot be shown: ${problem}. All of the map is shown instead.`,
    });
  });
});

const FLIGHT_MS = 700;
let flight = 0;

export function stopFlying(): void {
  if (flight) cancelAnimationFrame(flight);
  flight = 0;
}

/** The view on the way from one to another: zoom evenly, about the one point that both have at the same place. */
export function between(from: LocusView, to: LocusView, s: number): LocusView {
  if (s >= 1) return to;
  const zoom = from.zoom * (to.zoom / from.zoom) ** s;
  const span = 1 / from.zoom - 1 / to.zoom;
  // As zoom goes, so goes the middle; where the zoom stays, evenly.
  const k = Math.abs(span) < 1e-9 / to.zoom ? s : (1 / from.zoom - 1 / zoom) / span;
  return { ...to, zoom, x: from.x + k * (to.x - from.x), y: from.y + k * (to.y - from.y) };
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
