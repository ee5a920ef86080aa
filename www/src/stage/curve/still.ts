/** A closed curve as a picture of its own size: for files, and for the frames of films. */
import type { CurveMorph } from "#document/curve/curve";
import type { View } from "#geometry/coordinates";
import type { Bend, Colouring } from "#wasm/api";
import * as messages from "../messages";
import { lookOf, paintCurve, paintInside } from "./paint";
import { moved, TOLERANCE, windowOf } from "./painter";
import type { Carried } from "./photographs/carried";

export interface CurveStill {
  morph: CurveMorph;
  s: number;
  bend: Bend | null;
  view: View;
  width: number;
  height: number;
  colouring: Colouring;
  palette: readonly string[];
  /** Whether it is seen before something dark. */
  dark: boolean;
  /** Of the outline, in pixels. */
  lineWidth: number;
  /** What is seen inside in place of colours, unless it is bent. */
  carried?: Carried | null;
}

const MOST_POINTS = 100_000;

/** Throws where there is no canvas, or no such bend. */
export function stillCurve(still: CurveStill): OffscreenCanvas {
  const { morph, s, bend, view, width, height, colouring, palette, dark, lineWidth, carried } = still;
  const points = morph.polyline(s, {
    tolerance: TOLERANCE / view.scale,
    window: windowOf({ view, width, height, ratio: 1 }),
    bend: moved(bend),
    most: MOST_POINTS,
  });
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(messages.browserCouldNotCreate);
  const frame = { view, width, height };
  if (carried && !moved(bend)) paintInside(context, points, frame, carried.at(s, 1));
  else paintCurve(context, points, frame, lookOf(morph, s, colouring, palette, lineWidth, dark));
  return canvas;
}
