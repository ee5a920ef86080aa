/** Where (t, x) lies on the stage: two scales, since t and x are of other kinds. */
import { significant } from "#format/significant";

export interface Frame {
  /** What is shown. */
  t: readonly [from: number, to: number];
  x: readonly [from: number, to: number];
  /** The plot, in CSS pixels of the stage. */
  left: number;
  top: number;
  width: number;
  height: number;
}

export function leftOf(frame: Frame, t: number): number {
  return frame.left + ((t - frame.t[0]) / (frame.t[1] - frame.t[0])) * frame.width;
}

export function topOf(frame: Frame, x: number): number {
  return frame.top + ((frame.x[1] - x) / (frame.x[1] - frame.x[0])) * frame.height;
}

export function tAt(frame: Frame, left: number): number {
  return frame.t[0] + ((left - frame.left) / frame.width) * (frame.t[1] - frame.t[0]);
}

export function xAt(frame: Frame, top: number): number {
  return frame.x[1] - ((top - frame.top) / frame.height) * (frame.x[1] - frame.x[0]);
}

/** As fine as half a pixel shows, in round numbers: short in links, and the same on every machine. */
export function rounded(value: number, perPixel: number): number {
  if (!(perPixel > 0)) return value;
  const digits = Math.min(15, Math.max(0, Math.ceil(-Math.log10(perPixel / 2))));
  return Number(value.toFixed(digits));
}

export interface Ticks {
  values: number[];
  /** Decimals that tell them apart. */
  digits: number;
  /** From one to the next. */
  step: number;
}

/** Round numbers over a stretch, `most` of them at most. */
export function ticks([from, to]: readonly [number, number], most: number): Ticks {
  const size = to - from;
  if (!(size > 0) || !Number.isFinite(size) || most < 1) return { values: [], digits: 0, step: 0 };
  const raw = size / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((n) => n * power >= raw * (1 - 1e-9)) ?? 10);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const values: number[] = [];
  const first = Math.ceil(from / step - 1e-9);
  for (let k = first; k * step <= to + 1e-9 * step && values.length < 2 * most + 2; k++) {
    values.push(digits === 0 ? k * step : Number((k * step).toFixed(Math.min(20, digits))));
  }
  return { values, digits, step };
}

export function tickText(value: number, { digits, step }: Ticks): string {
  const size = Math.abs(value);
  if (size >= 1e6 || digits > 9) {
    const needed = step > 0 ? 1 + Math.ceil(Math.log10(size / step) - 1e-9) : 6;
    // A power of ten is shorter only where few digits stand before it.
    if (needed <= 4 || digits > 9) return significant(value, Math.min(15, Math.max(1, needed)));
  }
  return value
    .toFixed(digits)
    .replace(/^-(0(\.0*)?)$/, "$1")
    .replace("-", "−");
}

/** The heights of points within a stretch of t, or null where there are none. */
export function heights(
  points: ArrayLike<number>,
  [from, to]: readonly [number, number],
): readonly [number, number] | null {
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let i = startIn(points, from); i + 1 < points.length && (points[i] ?? 0) <= to; i += 2) {
    const x = points[i + 1] ?? 0;
    if (x < low) low = x;
    if (x > high) high = x;
  }
  return low <= high ? [low, high] : null;
}

/** Index of the first point at t or right of it; points are t0, x0, t1, x1, .. from left to right. */
export function startIn(points: ArrayLike<number>, t: number): number {
  let [low, high] = [0, points.length >> 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((points[2 * middle] ?? 0) < t) low = middle + 1;
    else high = middle;
  }
  return 2 * low;
}

/** With some air above and below; never without a height. */
export function aired([low, high]: readonly [number, number]): readonly [number, number] {
  const size = high - low;
  const air = size > 0 ? 0.08 * size : Math.max(1e-9, 0.5 * Math.abs(high), 0.5);
  return [low - air, high + air];
}
