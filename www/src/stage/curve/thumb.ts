/** Small pictures of closed curves. */

import type { CurveMorph } from "#document/curve/curve";
import { fitFor } from "#document/framing";
import type { Box } from "#geometry/boxes";
import { lookOf, paintCurve, paintInside } from "./paint";
import type { Carried } from "./photographs/carried";

/** CSS pixels. */
interface ThumbSize {
  width: number;
  height: number;
}

const EDGE = 5;
const LINE_WIDTH = 1.1;
/** Of the outline, in device pixels. */
const TOLERANCE = 0.5;
/** Photographs are made so many times smaller than they could be. */
const SMALLER = 4;

/** The curve at a moment, with a box of the plane fitted into it, and what is carried inside it. */
export function curveThumb(
  morph: CurveMorph,
  s: number,
  box: Box,
  size: ThumbSize,
  palette: readonly string[],
  carried: Carried | null = null,
): ImageBitmap {
  const ratio = Math.min(2, globalThis.devicePixelRatio || 1);
  const width = Math.round(size.width * ratio);
  const height = Math.round(size.height * ratio);
  const edge = EDGE * ratio;
  const view = fitFor(box, { width, height }, { top: edge, right: edge, bottom: edge, left: edge });
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d");
  if (context) {
    const vertices = morph.polyline(s, { tolerance: TOLERANCE / view.scale });
    const frame = { view, width, height };
    if (carried) paintInside(context, vertices, frame, carried.at(s, SMALLER));
    else paintCurve(context, vertices, frame, lookOf(morph, s, "density", palette, LINE_WIDTH * ratio));
  }
  return canvas.transferToImageBitmap();
}
