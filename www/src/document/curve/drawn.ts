/** What a link says of a spline as a closed curve that is drawn: fetched with what draws it. */
import type { Curve, CurveShape, Scene } from "#wasm/api";
import { curvesReady, rough } from "#wasm/curve";
import { notify, wordsOf } from "../notice";
import { centred } from "./centred";

/** The curve of a word as it is taken from a fit: straight sides in place of its parabolas, about the origin. */
export const takenSpline = (word: string): Curve => rough.quantised(centred(rough.splineCurve(word)));

/** One of a link that holds the word of a spline has no knots yet. */
export function drawn(shape: CurveShape): CurveShape {
  const { curve, spline } = shape;
  return spline === undefined || curve.knots.length > 0 ? shape : { ...shape, curve: takenSpline(spline) };
}

/**
 * Both ends of a morph, as they are until curves can be read; two of one word are one curve. A word that is none is
 * told, and nothing is drawn.
 */
export function drawnEnds(ends: NonNullable<Scene["curves"]>): NonNullable<Scene["curves"]> {
  if (!curvesReady.value) return ends;
  try {
    const [a, b] = [drawn(ends.a), drawn(ends.b)];
    return { a, b: b.spline !== undefined && b.spline === a.spline ? { ...b, curve: a.curve } : b };
  } catch (problem) {
    // Not while signals are computed.
    queueMicrotask(() => notify({ kind: "error", text: wordsOf(problem) }));
    return ends;
  }
}
