/** Paints a gap field, as far as it is known, into pixels. */

import { STATE } from "#geometry/states";
import {
  BROKEN,
  HIDDEN,
  HIDDEN_STRIPE,
  HOLDS,
  mixed,
  NARROWEST,
  NONE,
  REACH,
  type Rgb,
  ramp,
  TOUCHES,
  TOUCHES_DOT,
  UNDECIDED,
} from "#style/ramp";
import type { Bounds, Locus } from "#wasm/api";

export type LocusStyle = "gap" | "yesno";

interface PaintOptions {
  style: LocusStyle;
  /** Device pixels a CSS pixel: patterns keep their size on fine screens. */
  scale?: number;
  /** The least gap that counts, where the ramp begins. */
  epsilon?: number;
  /** What the square shows; by default all of the field. */
  window?: Bounds;
}

/** A pixel as one number, in the order of bytes of the machine. */
const LITTLE = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1;
const packed = ([r, g, b]: Rgb): number =>
  (LITTLE ? (255 << 24) | (b << 16) | (g << 8) | r : (r << 24) | (g << 16) | (b << 8) | 255) >>> 0;

const shades = (line: number) =>
  Uint32Array.from({ length: 256 }, (_, i) => packed(mixed(ramp(i / 255), HOLDS, line)));
const SHADES = shades(0);
/** Contours: every tenth of a gap, and fainter half-way between by its logarithm. */
const MAJOR = shades(0.4);
const MINOR = shades(0.15);
const STRIPE = packed(ramp(0.16));
const COLOURS = {
  holds: packed(HOLDS),
  touches: packed(TOUCHES),
  touchesDot: packed(TOUCHES_DOT),
  hidden: packed(HIDDEN),
  hiddenStripe: packed(HIDDEN_STRIPE),
  broken: packed(BROKEN),
  none: packed(NONE),
  open: packed(UNDECIDED),
};

/** Patterns, so that colour is never the only sign: `period` is a whole number of pixels. */
const hatched = (x: number, y: number, period: number) => (x + y) % period < period / 4;
const crossed = (x: number, y: number, period: number) =>
  (x + y) % period < 1.5 || (x - y + 512 * period) % period < 1.5;
const dotted = (x: number, y: number, period: number) => x % period < period / 3 && y % period < period / 3;
/** Few and small dots, every second row between the others. */
const sprinkled = (x: number, y: number, period: number) =>
  y % period < period / 10 && (x + (Math.floor(y / period) % 2) * (period >> 1)) % period < period / 10;

/** Half decades of a gap: each whole number is a contour, each even one a tenth of a gap. */
const contourOf = (gap: number): number => 2 * Math.log10(gap);
const NOWHERE = -1e6;

/**
 * RGBA, `size` x `size`, the highest v on top. Samples that are not decided, and what lies beyond the field, stay
 * clear.
 */
export function paint(
  field: Locus & { bounds: Bounds },
  size: number,
  { style, scale = 1, epsilon = NARROWEST, window }: PaintOptions,
): Uint8ClampedArray<ArrayBuffer> {
  const { width, height, state, bounds } = field;
  const seen = window ?? bounds;
  const heights = heightsOf(field);
  const lowest = contourOf(epsilon);
  const toShade = 255 / (contourOf(epsilon * REACH) - lowest);
  const pixels = new Uint32Array(size * size);
  const period = Math.max(4, Math.round(8 * scale));
  const columns = axis(size, width, bounds.u0, bounds.u1, seen.u0, seen.u1);
  const rows = axis(size, height, bounds.v0, bounds.v1, seen.v0, seen.v1);
  // The contour interval of the pixels of the row above, to see where one is crossed.
  const above = new Int32Array(size).fill(NOWHERE);
  for (let y = 0; y < size; y++) {
    const up = size - 1 - y;
    const nearRow = rows.near[up] ?? -1;
    if (nearRow < 0) {
      above.fill(NOWHERE);
      continue;
    }
    const near = nearRow * width;
    const low = (rows.low[up] ?? 0) * width;
    const high = height > 1 ? low + width : low;
    const part = rows.part[up] ?? 0;
    let before = NOWHERE;
    for (let x = 0; x < size; x++) {
      const column = columns.near[x] ?? -1;
      const at = near + column;
      let interval = NOWHERE;
      let pixel = 0;
      switch (column < 0 ? STATE.pending : state[at]) {
        case STATE.connected:
          pixel = COLOURS.holds;
          break;
        case STATE.touching:
          pixel = sprinkled(x, y, 2 * period) ? COLOURS.touchesDot : COLOURS.touches;
          break;
        case STATE.hidden:
          pixel = hatched(x, y, 2 * period) ? COLOURS.hiddenStripe : COLOURS.hidden;
          break;
        case STATE.disconnected:
          if (style === "yesno") {
            pixel = hatched(x, y, period) ? STRIPE : COLOURS.broken;
          } else {
            const left = columns.low[x] ?? 0;
            const right = width > 1 ? left + 1 : left;
            const k = columns.part[x] ?? 0;
            const p = heights[low + left] ?? NOWHERE;
            const q = heights[low + right] ?? NOWHERE;
            const r = heights[high + left] ?? NOWHERE;
            const s = heights[high + right] ?? NOWHERE;
            // Shaded between four samples only where all are broken: the border stays as sharp as it is known.
            const smooth = p > NOWHERE && q > NOWHERE && r > NOWHERE && s > NOWHERE;
            const here = smooth
              ? p + k * (q - p) + part * (r + k * (s - r) - p - k * (q - p))
              : (heights[at] ?? lowest);
            const shade = Math.min(255, Math.max(0, Math.round((here - lowest) * toShade)));
            if (smooth) interval = Math.floor(here);
            const line = crossing(interval, before, above[x] ?? NOWHERE);
            pixel = (line === 0 ? SHADES : line === 1 ? MINOR : MAJOR)[shade] ?? COLOURS.broken;
          }
          break;
        case STATE.undecided:
          pixel = dotted(x, y, period) ? COLOURS.none : COLOURS.open;
          break;
        case STATE.none:
          pixel = crossed(x, y, period) ? COLOURS.open : COLOURS.none;
          break;
      }
      pixels[y * size + x] = pixel;
      before = interval;
      above[x] = interval;
    }
  }
  return new Uint8ClampedArray(pixels.buffer);
}

/** Whether a contour runs between a pixel and its neighbours: 0 no, 1 a half-way one, 2 that of a tenth. */
export function crossing(here: number, left: number, above: number): 0 | 1 | 2 {
  if (here === NOWHERE) return 0;
  const horizontal = left !== NOWHERE && left !== here ? Math.max(left, here) : NOWHERE;
  const vertical = above !== NOWHERE && above !== here ? Math.max(above, here) : NOWHERE;
  if (horizontal === NOWHERE && vertical === NOWHERE) return 0;
  const even = (n: number) => n !== NOWHERE && n % 2 === 0;
  return even(horizontal) || even(vertical) ? 2 : 1;
}

/** For each broken sample the logarithm of its gap, in half decades; NOWHERE for all others. */
function heightsOf({ state, gap }: Locus): Float32Array {
  const heights = new Float32Array(gap.length).fill(NOWHERE);
  for (let i = 0; i < heights.length; i++) {
    const g = gap[i] ?? 0;
    if (state[i] === STATE.disconnected) heights[i] = g > 0 ? contourOf(g) : -60;
  }
  return heights;
}

/**
 * Where the middle of each pixel falls on an axis: the nearest sample, the one below, and how far on to the next. -1
 * for pixels beyond the samples, which own half a step more than they span.
 */
function axis(size: number, samples: number, first: number, last: number, from: number, to: number) {
  const step = samples > 1 ? (last - first) / (samples - 1) : 1;
  const at = Float64Array.from({ length: size }, (_, i) => {
    // The two differences are exact where the window is small: no digits are lost in the depth.
    return step === 0 ? 0 : (from - first) / step + ((i + 0.5) / size) * ((to - from) / step);
  });
  const low = Int32Array.from(at, (x) => Math.max(0, Math.min(samples - 2, Math.floor(x))));
  return {
    near: Int32Array.from(at, (x) =>
      samples > 1 && (x < -0.5 || x > samples - 0.5) ? -1 : Math.min(samples - 1, Math.max(0, Math.round(x))),
    ),
    low,
    part: Float32Array.from(at, (x, i) => Math.min(1, Math.max(0, x - (low[i] ?? 0)))),
  };
}

/** Gaps that have a contour of their own, from the least that counts to the widest of the ramp. */
export function decades(epsilon: number): { gap: number; at: number }[] {
  const found = [];
  const first = Math.ceil(Math.log10(epsilon) + 1e-9);
  for (let power = first; 10 ** power < 0.999 * epsilon * REACH; power++) {
    found.push({ gap: 10 ** power, at: Math.log(10 ** power / epsilon) / Math.log(REACH) });
  }
  return found;
}
