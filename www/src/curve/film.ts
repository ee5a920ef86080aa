/** Closed curves as frames of films. */
import { curves } from "#document/curve/curve";
import type { Photographs } from "#document/curve/photographs";
import type { View } from "#geometry/coordinates";
import { carriedOn } from "#stage/curve/photographs/carried";
import { stillCurve } from "#stage/curve/still";
import { isDark } from "#style/ground";
import { palette } from "#style/palette";
import type { Bend, Colouring } from "#wasm/api";
import { rough } from "#wasm/curve";
import type { Drawer, FrameLook } from "#workers/film/subject";
import { turn } from "#workers/film/turn";
import * as messages from "./messages";

export interface CurveMoment {
  /** On the way from one curve to the other, 0 to 1. */
  s: number;
  bend: Bend | null;
  view: View;
}

/** Of the outline, as a part of the shorter side of a frame. */
const LINE_WIDTH = 1 / 400;

/**
 * Draws the curves of the document on the page itself, one frame after the other: each takes it a moment only. The
 * photographs of both ends are carried inside them.
 */
export function curveDrawer(
  { width, height, ground }: FrameLook,
  colouring: Colouring,
  at: (seconds: number) => CurveMoment,
  photographs: Photographs | null = null,
): Drawer {
  const now = curves.peek();
  if (!now) throw new Error(messages.thereNoCurve);
  const morph = new rough.CurveMorph(now.a.curve, now.a.curve === now.b.curve ? null : now.b.curve);
  const dark = isDark(ground);
  const carried = carriedOn(morph, photographs);
  const look = { width, height, colouring, palette: palette(dark ? "dark" : "light"), dark, carried };
  const lineWidth = Math.max(1, LINE_WIDTH * Math.min(width, height));
  let before = "";
  let missing = 0;
  return {
    hands: 1,
    get missing() {
      return missing;
    },
    async frame(seconds, signal) {
      const moment = at(seconds);
      const key = JSON.stringify(moment);
      if (key === before) return null;
      before = key;
      // The page has its turn between two frames.
      await turn();
      signal.throwIfAborted();
      const began = performance.now();
      try {
        const canvas = stillCurve({ ...look, ...moment, morph, lineWidth });
        const image = canvas.getContext("2d")?.getImageData(0, 0, width, height);
        if (!image) return null;
        return {
          width,
          height,
          data: image.data as Uint8ClampedArray<ArrayBuffer>,
          took: performance.now() - began,
        };
      } catch {
        missing++;
        return null;
      }
    },
    end: () => morph.free(),
  };
}
