/** What the document says of fitting, and how that is changed. */
import { computed, type ReadonlySignal } from "@preact/signals";
import type { CurvePreset, CurveShape, Fit, Scene, Shape } from "#wasm/api";
import { edit, replace, scene } from "./scene";
import { openTool } from "./tool";

/** What stands for a document that says nothing of fitting. */
const PLAIN_FIT: Fit = { mode: "outline", model: "closed", numbers: 260, smoothing: 0 };

/** How many bytes a fit by corners and parabolas may take, where a document says nothing. */
const USUAL_BYTES = 150;

/** How many bytes it may take. */
export const bytesOf = (fit: Fit): number => fit.bytes ?? USUAL_BYTES;

/** With so many bytes: the usual number is not written. */
export function withBytes({ bytes: _, ...fit }: Fit, bytes: number): Fit {
  return bytes === USUAL_BYTES ? fit : { ...fit, bytes };
}

/** What the document says of fitting. */
export const fitDocument: ReadonlySignal<Fit> = computed(() => scene.value.fit ?? PLAIN_FIT);

/** One undo step, or a part of one (see `edit`). A change that returns the fit it was given does nothing. */
export function changeFit(change: (fit: Fit) => Fit, options: { gesture?: string } = {}): void {
  edit((now) => withFit(now, change), options);
}

/** Without an undo step: what a fit has come to by itself. */
export function replaceFit(change: (fit: Fit) => Fit): void {
  replace(withFit(scene.peek(), change));
}

function withFit(now: Scene, change: (fit: Fit) => Fit): Scene {
  const before = now.fit ?? PLAIN_FIT;
  const after = change(before);
  return after === before ? now : { ...now, fit: after };
}

/** Where a fit goes: an end of the morph, or under the grid. */
export type Use = "a" | "b" | "bent";

/** Takes a system of maps into the morph or under the grid: one undo step, then the tool. Outlines give way to it. */
export function takeMaps(shape: Shape, to: Use): void {
  const end = to === "b" ? "b" : "a";
  edit((now) => {
    const { locus: _locus, view: _view, directed: _directed, curves: _curves, ...rest } = now;
    return { ...rest, [end]: shape, correspondence: [], turns: [], t: end === "a" ? 0 : 1 };
  });
  openTool(to === "bent" ? "deform" : "morph");
}

/**
 * Takes a curve into the morph or under the grid: one undo step, then the tool, at the moment that shows the curve. The
 * other end stays the curve it is; where there are no curves yet, it is one of the gallery's.
 */
export function useCurve(shape: CurveShape, partner: CurvePreset, to: Use): void {
  const { id: preset, name, curve } = partner;
  const end = to === "b" ? "b" : "a";
  edit((now) => {
    const { locus: _locus, view: _view, directed: _directed, ...rest } = now;
    const other = { preset, name, curve };
    const { a, b } = now.curves ?? { a: other, b: other };
    return { ...rest, curves: { a, b, [end]: shape }, t: end === "a" ? 0 : 1 };
  });
  openTool(to === "bent" ? "deform" : "morph");
}
