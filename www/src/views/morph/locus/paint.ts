/** Paints a gap field, as far as it is known, into pixels. */
import { STATE } from "../../../engine/breaks";
import type { LocusResult } from "../../../engine/results";
import { BROKEN, HOLDS, NONE, type Rgb, ramp, shadeOf, UNDECIDED } from "../../../style/ramp";

export type LocusStyle = "gap" | "yesno";

/** A pixel as one number, in the order of bytes of the machine. */
const LITTLE = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1;
const packed = ([r, g, b]: Rgb): number =>
  (LITTLE ? (255 << 24) | (b << 16) | (g << 8) | r : (r << 24) | (g << 16) | (b << 8) | 255) >>> 0;

const SHADES = Uint32Array.from({ length: 256 }, (_, i) => packed(ramp(i / 255)));
const STRIPE = packed(ramp(0.16));
const COLOURS = { holds: packed(HOLDS), broken: packed(BROKEN), none: packed(NONE), open: packed(UNDECIDED) };

/** Patterns, so that colour is never the only sign: `period` is a whole number of pixels. */
const hatched = (x: number, y: number, period: number) => (x + y) % period < period / 4;
const crossed = (x: number, y: number, period: number) =>
  (x + y) % period < 1.5 || (x - y + 512 * period) % period < 1.5;
const dotted = (x: number, y: number, period: number) => x % period < period / 3 && y % period < period / 3;

/**
 * RGBA, `size` x `size`, the highest v on top; both ends of each axis are samples, so the outermost ones own half a
 * cell. Samples that are not decided stay clear. `scale` is device pixels a CSS pixel: patterns keep their size on fine
 * screens.
 */
export function paint(
  field: LocusResult,
  size: number,
  style: LocusStyle,
  scale = 1,
): Uint8ClampedArray<ArrayBuffer> {
  const { width, height, state } = field;
  const shades = shadesOf(field);
  const pixels = new Uint32Array(size * size);
  const period = Math.max(4, Math.round(8 * scale));
  const columns = axis(size, width);
  const rows = axis(size, height);
  for (let y = 0; y < size; y++) {
    const up = size - 1 - y;
    const near = (rows.near[up] ?? 0) * width;
    const low = (rows.low[up] ?? 0) * width;
    const high = height > 1 ? low + width : low;
    const part = rows.part[up] ?? 0;
    for (let x = 0; x < size; x++) {
      const at = near + (columns.near[x] ?? 0);
      let pixel = COLOURS.holds;
      switch (state[at]) {
        case STATE.pending:
          continue;
        case STATE.disconnected:
          if (style === "yesno") {
            pixel = hatched(x, y, period) ? STRIPE : COLOURS.broken;
          } else {
            const left = columns.low[x] ?? 0;
            const right = width > 1 ? left + 1 : left;
            const k = columns.part[x] ?? 0;
            const p = shades[low + left] ?? -1;
            const q = shades[low + right] ?? -1;
            const r = shades[high + left] ?? -1;
            const s = shades[high + right] ?? -1;
            // Shaded between four samples only where all are broken: the border stays as sharp as it is known.
            const shade =
              p < 0 || q < 0 || r < 0 || s < 0
                ? (shades[at] ?? 0)
                : p + k * (q - p) + part * (r + k * (s - r) - p - k * (q - p));
            pixel = SHADES[Math.round(shade)] ?? COLOURS.broken;
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
    }
  }
  return new Uint8ClampedArray(pixels.buffer);
}

/** For each broken sample its place on the scale, 0 to 255; -1 for all others. */
function shadesOf({ state, gap }: LocusResult): Float32Array {
  return Float32Array.from(gap, (g, i) => (state[i] === STATE.disconnected ? 255 * shadeOf(g) : -1));
}

/** Where the middle of each pixel falls on an axis: the nearest sample, the one below, and how far on to the next. */
function axis(size: number, samples: number): { near: Int32Array; low: Int32Array; part: Float32Array } {
  const at = Float64Array.from({ length: size }, (_, i) => ((i + 0.5) / size) * (samples - 1));
  const low = Int32Array.from(at, (x) => Math.max(0, Math.min(samples - 2, Math.floor(x))));
  return {
    near: Int32Array.from(at, Math.round),
    low,
    part: Float32Array.from(at, (x, i) => x - (low[i] ?? 0)),
  };
}
