/** Fits within so many bytes as closed curves of corners alone. */
import type { Curve, CurveShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import { centred } from "./centred";

/** The last ones are remembered: shelves ask again and again. */
const MOST = 8;
const made = new Map<string, Curve>();
const taken = new Map<string, Curve>();

function remembered(all: Map<string, Curve>, word: string, make: () => Curve): Curve {
  const before = all.get(word);
  if (before) return before;
  const curve = make();
  all.set(word, curve);
  for (const old of all.keys()) {
    if (all.size <= MOST) break;
    all.delete(old);
  }
  return curve;
}

/** A fit as it is taken into the morph: about the origin, and as a link holds it. */
export const takenCurve = (curve: Curve): Curve => rough.quantised(centred(curve));

/** The curve of a word with short straight sides in place of its parabolas, where it was fitted. */
export const polygonOf = (word: string): Curve => remembered(made, word, () => rough.splineCurve(word));

/** The same as the morph and the grid take it. */
export const takenPolygon = (word: string): Curve =>
  remembered(taken, word, () => takenCurve(polygonOf(word)));

/** A shape as it is drawn: one of a link that holds the word of a spline has no knots yet. */
export function drawable(shape: CurveShape): CurveShape {
  if (shape.spline === undefined || shape.curve.knots.length > 0) return shape;
  return { ...shape, curve: takenPolygon(shape.spline) };
}
