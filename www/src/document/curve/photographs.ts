/** Photographs of the leaves that curves were fitted to: in this page alone, since a link does not hold them. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import type { Curve, Fit } from "#wasm/api";
import { frond } from "#wasm/core";
import { curvesReady, rough } from "#wasm/curve";
import type { KeptPhotograph } from "../kept/fits";
import { centred, centredBox, centringOf } from "./centred";
import { curves } from "./curve";
import { polygonOf } from "./polygon";

/** A photograph, and where it lies in the plane of its curve: left, bottom, right, top. */
export interface CurvePhotograph {
  image: ImageBitmap;
  box: readonly [x0: number, y0: number, x1: number, y1: number];
}

/** Those of both ends of a morph. */
export interface Photographs {
  a: CurvePhotograph;
  b: CurvePhotograph;
}

/** They take memory: the last ones are held. */
const MOST_HELD = 6;

/** By the curve, packed. */
const held = signal<ReadonlyMap<string, CurvePhotograph>>(new Map());
const keys = new WeakMap<Curve, string>();

function keyOf(curve: Curve): string {
  const known = keys.get(curve);
  if (known !== undefined) return known;
  const key = rough.packCurve(curve);
  keys.set(curve, key);
  return key;
}

/** A fit as it is taken into the morph: about the origin, and as a link holds it. */
export const takenCurve = (curve: Curve): Curve => rough.quantised(centred(curve));

/** The photograph of a fit goes along, wherever its curve goes. */
export async function holdPhotograph(fit: Curve, { blob, box }: KeptPhotograph): Promise<CurvePhotograph> {
  const key = keyOf(takenCurve(fit));
  const known = held.peek().get(key);
  if (known) return known;
  const made = { image: await createImageBitmap(blob), box: centredBox(box, centringOf(fit)) };
  const next = new Map(held.peek()).set(key, made);
  for (const old of next.keys()) {
    if (next.size <= MOST_HELD) break;
    next.delete(old);
  }
  held.value = next;
  return made;
}

/** The photographs of the two ends; null where there are not both. */
export const photographs: ReadonlySignal<Photographs | null> = computed(() => {
  const now = curves.value;
  if (!now || !curvesReady.value) return null;
  try {
    const [a, b] = [held.value.get(keyOf(now.a.curve)), held.value.get(keyOf(now.b.curve))];
    return a && b ? { a, b } : null;
  } catch {
    return null;
  }
});

/** Whether they are shown where there are both. */
export const photographsShown = signal(true);

/** What is seen of them wherever the morph is: on the stage, in its strip, in pictures and films. */
export const photographsSeen: ReadonlySignal<Photographs | null> = computed(() =>
  photographsShown.value ? photographs.value : null,
);

/** Curves that were looked for in vain. */
const sought = new Set<string>();

/** Looks for photographs of the document's curves among the fits that are kept. Returns the end of it. */
export function watchPhotographs(): () => void {
  return effect(() => {
    const now = curves.value;
    if (!now || !curvesReady.value) return;
    untracked(() => void lookFor([now.a.curve, now.b.curve]));
  });
}

/** The curve of a fit as it was taken from it. */
const curveOf = (fit: Fit | undefined): Curve | undefined =>
  fit?.spline ? polygonOf(fit.spline.word) : fit?.curve?.curve;

async function lookFor(all: readonly Curve[]): Promise<void> {
  try {
    const wanted = new Set(all.map(keyOf).filter((key) => !held.peek().has(key) && !sought.has(key)));
    if (wanted.size === 0) return;
    const { Fits } = await import("../kept/fits");
    for (const { fragment, photograph } of await new Fits().list()) {
      const fit = photograph && curveOf(frond.decodeScene(fragment).scene.fit);
      if (fit && wanted.has(keyOf(takenCurve(fit)))) await holdPhotograph(fit, photograph);
    }
    for (const key of wanted) if (!held.peek().has(key)) sought.add(key);
  } catch {
    // Without their photographs curves are what they are.
  }
}
