/** Photographs of the leaves that curves were fitted to: in this page alone, since a link does not hold them. */
import type { Curve } from "#wasm/api";
import { rough } from "#wasm/curve";
import type { KeptPhotograph } from "../kept/fits";
import { centred, centredBox, centringOf } from "./centred";

/** A photograph, and where it lies in the plane of its curve: left, bottom, right, top. */
export interface CurvePhotograph {
  image: ImageBitmap;
  box: readonly [x0: number, y0: number, x1: number, y1: number];
}

/** They take memory: the last ones are held. */
const MOST_HELD = 6;

/** By the curve, packed. */
const held = new Map<string, CurvePhotograph>();
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
  const known = held.get(key);
  if (known) return known;
  const made = { image: await createImageBitmap(blob), box: centredBox(box, centringOf(fit)) };
  held.set(key, made);
  for (const old of held.keys()) {
    if (held.size <= MOST_HELD) break;
    held.delete(old);
  }
  return made;
}
