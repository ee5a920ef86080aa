/** What is on the stage of the fit now. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import type { View } from "#geometry/coordinates";
import type { Curve } from "#wasm/api";
import { fitTask } from "#workers/fit/client";
import type { Stroke } from "#workers/fit/trace-types";
import { copyPaths, grown } from "../copies/copies";
import { collage, collageOptions, shownFit } from "../work/fitting";
import { masked, settings } from "../work/mask";
import { frame, prepared, raw, ready } from "../work/outline";
import { opened } from "../work/source";
import { nodesOf, shownWithin } from "../work/within";
import { cursor, hand, painting, radius, stroke } from "./brush";
import { effectiveView, stageSize } from "./camera";
import type { Sight } from "./draw";
import { comparing, cutting, knotsShown, outlineShown, photoShown } from "./layers";
import { FitLine } from "./line";

/** What is fitted. */
const model = computed(() => fitDocument.value.model);

/** Feature points of the paper's fit, when they are shown. */
export const featurePoints = signal<Float64Array | null>(null);

/** Asks for the feature points of the paper's fit while they are shown. Returns the end of it. */
export function watchFeatures(): () => void {
  return effect(() => {
    const outline = prepared.value;
    if (!outline || model.value !== "collage" || !knotsShown.value) return;
    const count = collageOptions.value.features;
    fitTask("features", { points: outline.points, count }, { lane: 1 }).then(
      (points) => {
        if (prepared.peek() === outline) featurePoints.value = points;
      },
      // The fit says what is wrong with it.
      () => {},
    );
  });
}

const line = new FitLine();

/** As fine as it is seen; where that fails, as the worker drew it. */
function polyline(curve: Curve, plain: Float64Array, view: View): Float64Array {
  try {
    return line.of(curve, view, stageSize.peek(), globalThis.devicePixelRatio || 1);
  } catch {
    return plain;
  }
}

const NONE = new Float64Array();

/** Of a fit within bytes, where they are shown. */
const nodes = computed(() => {
  const within = model.value === "spline" && knotsShown.value ? shownWithin.value : null;
  try {
    return within && nodesOf(within.word);
  } catch {
    return null;
  }
});

/** What is painted exactly is seen by what it does. */
const isHint = ({ exact }: Stroke) => !exact;

export const sight: ReadonlySignal<Sight> = computed(() => {
  const picture = opened.value;
  const cut = cutting.value;
  const outline = prepared.value?.points ?? raw.value;
  const early = prepared.value ? null : ready.value;
  const what = model.value;
  const fit = what === "closed" ? (shownFit.value ?? (early && { curve: early, points: NONE })) : null;
  const within = what === "spline" ? shownWithin.value : null;
  const paper = what === "collage" && collage.value?.of === prepared.value ? collage.value : null;
  const own = fit || within || paper;
  const alone = comparing.value;
  const shown = !cut && !alone;
  const knots = fit?.curve.knots.flat();
  const marks = what === "collage" ? featurePoints.value : knots ? new Float64Array(knots) : nodes.value;
  const paints = painting.value;
  const at = cursor.value;
  const brush = hand.value;
  return {
    photo:
      picture && (cut || photoShown.value || alone)
        ? { bitmap: picture.bitmap, width: picture.width, height: picture.height, faint: !cut && !alone }
        : null,
    mask: cut && !alone ? masked.value : null,
    frame: frame.value,
    outline: outline && (cut || alone || outlineShown.value || !own) ? outline : null,
    filled: !cut && !picture && (alone || !own),
    fit: !shown
      ? null
      : fit
        ? (grown.value ?? polyline(fit.curve, fit.points, effectiveView.value))
        : (within?.points ?? null),
    copies: shown && fit ? copyPaths.value : null,
    collage: shown && paper ? paper.fit : null,
    marks: shown && knotsShown.value ? marks : null,
    strokes: paints
      ? [...settings.value.strokes.filter(isHint), ...(stroke.value ? [stroke.value] : [])]
      : [],
    cursor: paints && at && brush !== "move" ? { ...at, radius: radius.value, what: brush } : null,
  };
});
