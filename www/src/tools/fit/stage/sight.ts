/** What is on the stage of the fit now. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import type { Size, View } from "#geometry/coordinates";
import type { Curve } from "#wasm/api";
import { type CurveMorphHandle, rough } from "#wasm/curve";
import { fitTask } from "#workers/fit/client";
import type { Stroke } from "#workers/fit/trace-types";
import { copyPaths, grown } from "../copies/copies";
import { collage, collageOptions, shownFit } from "../work/fitting";
import { masked, settings } from "../work/mask";
import { frame, prepared, raw, ready, sameCurve } from "../work/outline";
import { opened } from "../work/source";
import { nodesOf, shownWithin } from "../work/within";
import { cursor, hand, painting, radius, stroke } from "./brush";
import { effectiveView, stageSize } from "./camera";
import type { Sight } from "./draw";
import { comparing, cutting, knotsShown, outlineShown, photoShown } from "./layers";

// The fit as a polyline, as fine as it is seen and no finer.

/** It leaves the curve by half a device pixel at most, where so many points allow it. */
const LEAVE = 0.5;
/** A curve whose copies shrink little is rough all over: more points than these take longer than a frame. */
const MOST_POINTS = 20_000;
/** So many points for each device pixel of a side of the stage. */
const POINTS_A_PIXEL = 8;
const FEWEST_POINTS = 1000;
/** How far beyond the middle of the stage it is drawn, in sides of the stage. */
const BEYOND = 0.6;

interface Fineness {
  tolerance: number;
  most: number;
  window: [x0: number, y0: number, x1: number, y1: number];
}

/** How fine a polyline has to be in a picture of so many CSS pixels. */
export function fineness(view: View, { width, height }: Size, ratio: number): Fineness {
  const [x, y] = [(BEYOND * width) / view.scale, (BEYOND * height) / view.scale];
  const many = POINTS_A_PIXEL * ratio * (width + height);
  return {
    tolerance: LEAVE / view.scale / ratio,
    most: Math.round(Math.min(MOST_POINTS, Math.max(FEWEST_POINTS, many))),
    window: [view.x - x, view.y - y, view.x + x, view.y + y],
  };
}

/** Draws one curve at a time; what was drawn last is given again as long as neither it nor the view is another. */
export class FitLine {
  #last: { curve: Curve; handle: CurveMorphHandle; key: string; points: Float64Array | null } | null = null;

  /** Throws where the curve is none. */
  of(curve: Curve, view: View, size: Size, ratio: number): Float64Array {
    if (!this.#last || !sameCurve(this.#last.curve, curve)) {
      this.#last?.handle.free();
      this.#last = null;
      this.#last = { curve, handle: new rough.CurveMorph(curve, null), key: "", points: null };
    }
    const last = this.#last;
    const how = fineness(view, size, ratio);
    const key = JSON.stringify(how);
    if (last.points && last.key === key) return last.points;
    const points: Float64Array = last.handle.polyline(0, how);
    Object.assign(last, { key, points });
    return points;
  }
}

/** What is fitted. */
const model = computed(() => fitDocument.value.model);

/** Feature points of the paper's fit, when they are shown. */
const featurePoints = signal<Float64Array | null>(null);

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
