/** A fit becomes a shape like any other. */
import { effect, signal, untracked } from "@preact/signals";
import { cutOut } from "#document/curve/cut-out";
import { holdPhotograph, takenCurve } from "#document/curve/photographs";
import { tellReplaced } from "#document/curve/replaced";
import { bendPicture } from "#document/deform/bend-picture";
import { fernBecomes, withOutline } from "#document/directed/outlines";
import { fitDocument, useCurve as takeCurve, type Use } from "#document/fit";
import type { KeptPhotograph } from "#document/kept/fits";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import type { Curve, CurveShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import { croppedPhotograph } from "./kept/photograph";
import * as messages from "./messages";
import { shapeOf, shownFigures, shownFit } from "./work/fitting";
import { polylineOf, prepared } from "./work/outline";
import { problem, running } from "./work/progress";
import { source } from "./work/source";
import { polygonShape, shownWithin, withinDone } from "./work/within";

/** The fit on the stage as a closed curve: one within bytes with straight sides in place of its parabolas. */
export function shownShape(): CurveShape | null {
  if (fitDocument.peek().model === "spline") {
    const within = shownWithin.peek();
    return within && polygonShape(within.word);
  }
  const best = shownFit.peek();
  return best && shapeOf(best.curve);
}

/** Where the fit goes as soon as it is done. */
export const waiting = signal<Use | null>(null);

/** Takes the fit into another tool. One that still improves goes there when it is done. */
export function use(to: Use): void {
  if (running.peek()) waiting.value = waiting.peek() === to ? null : to;
  else take(to);
}

const spline = () => fitDocument.value.model === "spline";

/** Takes along what was to wait for its end. Returns the end of it. */
export function watchUse(): () => void {
  let outline = prepared.peek();
  const stop = effect(() => {
    const to = waiting.value;
    const of = prepared.value;
    // Of another outline nobody has said so.
    if (of !== outline || problem.value !== null) waiting.value = null;
    else if (to !== null && !running.value && (spline() ? withinDone.value : shownFigures.value)) {
      waiting.value = null;
      untracked(() => take(to));
    }
    outline = of;
  });
  return () => {
    stop();
    waiting.value = null;
  };
}

function take(to: Use): void {
  const now = source.peek();
  try {
    const shape = shownShape();
    if (!shape) return;
    void croppedPhotograph().then((photograph) => photograph && hold(shape.curve, photograph));
    takeShape(shape, to, now.kind === "grown" ? now.grown : undefined);
  } catch (problem) {
    notTaken(problem);
  }
}

const hold = (curve: Curve, photograph: KeptPhotograph): unknown =>
  // Without it the curve is what it is.
  holdPhotograph(curve, photograph).catch(() => {});

/** A fern becomes the fit, as it stands. */
export function fernFit(): void {
  try {
    const shape = shownShape();
    if (shape) void fernBecomes({ ...shape, curve: takenCurve(shape.curve) });
  } catch (problem) {
    notTaken(problem);
  }
}

/** Takes a fit of the shelf into another tool, and its photograph with it. */
export function takeKept(shape: CurveShape, photograph: KeptPhotograph | null, to: Use): void {
  if (photograph) void hold(shape.curve, photograph);
  takeShape(shape, to);
}

/** Takes the leaf of a photograph under the grid, cut out along its curve. */
export async function bendPhotograph(
  name: string,
  curve: Curve,
  given: KeptPhotograph | Promise<KeptPhotograph | null>,
): Promise<void> {
  try {
    const photograph = await given;
    if (!photograph) throw new Error(messages.thereNoneAnyMore);
    const { image, box } = await holdPhotograph(curve, photograph);
    const outline = polylineOf(takenCurve(curve));
    if (!outline) throw new Error(messages.curveCannotDrawn);
    const { data: pixels, width, height } = cutOut(image, box, outline);
    bendPicture({ pixels, width, height, name });
  } catch (problem) {
    notify({ kind: "error", text: messages.photoNotDeformed(wordsOf(problem)) });
  }
}

/** Takes a curve into another tool; `grown` says what kind of outline it was made for. */
function takeShape(shape: CurveShape, to: Use, grown: string | undefined = shape.preset): void {
  try {
    const taken = shape.preset ? shape : { ...shape, curve: takenCurve(shape.curve) };
    const presets = rough.curvePresets();
    // A leaf of the gallery goes to the oak's, unless it is that; whatever else to the maple's.
    const wanted = grown !== undefined && grown !== "white-oak" ? "white-oak" : "sugar-maple";
    const partner = presets.find((preset) => preset.id === wanted) ?? presets[0];
    if (!partner) throw new Error(messages.thereNoOtherShape);
    const before = scene.peek();
    const beside = to === "bent" ? undefined : before.directed?.[to === "a" ? "b" : "a"];
    // A plant that becomes outlines already becomes this one.
    if (to !== "bent" && beside && beside.outline === undefined) {
      void withOutline(to, taken, beside);
      return;
    }
    takeCurve(taken, partner, to);
    tellReplaced(before, to);
  } catch (problem) {
    notTaken(problem);
  }
}

function notTaken(problem: unknown): void {
  notify({ kind: "error", text: messages.fitNotUsed(wordsOf(problem)) });
}
