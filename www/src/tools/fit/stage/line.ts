/** The fit as a polyline, as fine as it is seen and no finer. */
import type { Size, View } from "#geometry/coordinates";
import type { Curve } from "#wasm/api";
import { type CurveMorphHandle, rough } from "#wasm/curve";
import { sameCurve } from "../same-curve";

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
