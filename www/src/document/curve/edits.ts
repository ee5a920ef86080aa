/** Edits that go from systems to closed curves, with the mesh going along. Each is one undo step. */
import type { CurvePreset, CurveShape, Scene } from "#wasm/api";
import { rough } from "#wasm/curve";
import { boxAround } from "../framing";
import { edit, scene } from "../scene";
import { type End, withCurve } from "./changes";
import { curveBox, curved } from "./curve";
import { drawn, takenSpline } from "./drawn";

let loaded: readonly CurvePreset[] | null = null;

/** The closed curves of the gallery, in its order. */
export function curvePresets(): readonly CurvePreset[] {
  loaded ??= rough.curvePresets();
  return loaded;
}

/** The preset as an end of a morph. */
export function shapeOf({ id, name, curve }: CurvePreset): CurveShape {
  return { preset: id, name, curve };
}

/** What a curve morphs with while nothing is chosen for the other end: the first preset that it is not. */
function partnerOf(shape: CurveShape): CurveShape {
  const other = curvePresets().find(({ id }) => id !== shape.preset);
  return other ? shapeOf(other) : shape;
}

const around = (now: Scene) => (now.curves ? boxAround(curveBox(drawn(now.curves.a).curve)) : null);

/** A curve for one end of the morph. */
export function chooseCurve(end: End, shape: CurveShape): void {
  const first = !curved.peek();
  const partner = partnerOf(shape);
  // Among curves a mesh stays where the hand has put it.
  edit((before) => withCurve(before, end, shape, partner, first ? around : undefined));
}

/**
 * A curve to be bent: the first shape of the morph becomes it, the moment goes to the start, and the mesh around it.
 */
export function bendCurve(shape: CurveShape): void {
  const partner = partnerOf(shape);
  edit((before) => ({ ...withCurve(before, "a", shape, partner, around), t: 0 }));
}

/** What the fit has found, as an end of a morph. */
export function fitted(): CurveShape | null {
  const fit = scene.peek().fit;
  const { spline } = fit ?? {};
  if (!spline) return fit?.curve ?? null;
  try {
    const { name, word } = spline;
    return { name, curve: takenSpline(word), spline: word };
  } catch {
    return null;
  }
}
