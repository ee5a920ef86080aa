/** Paints a gap field, as far as it is known, into pixels. */
import { STATE } from "../../../engine/breaks";
import type { LocusResult } from "../../../engine/results";
import { BROKEN, HOLDS, NONE, type Rgb, ramp, shadeOf, UNDECIDED } from "./ramp";

export type LocusStyle = "gap" | "yesno";

const SHADES: readonly Rgb[] = Array.from({ length: 256 }, (_, i) => ramp(i / 255));

/**
 * For each sample the sample that speaks for it: itself once it is decided, until then the nearest one of the
 * coarser grids. -1 where none of them is decided.
 */
export function fillIn({
  width,
  height,
  state,
}: Pick<LocusResult, "width" | "height" | "state">): Int32Array {
  const from = new Int32Array(width * height);
  const coarser = (i: number, stride: number, size: number) => {
    const near = Math.round(i / stride) * stride;
    return near < size ? near : Math.floor(i / stride) * stride;
  };
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      let at = y * width + x;
      for (let stride = 2; state[at] === STATE.pending; stride *= 2) {
        if (stride > 2 * Math.max(width, height)) {
          at = -1;
          break;
        }
        at = coarser(y, stride, height) * width + coarser(x, stride, width);
      }
      from[y * width + x] = at;
    }
  }
  return from;
}

/** Patterns, so that colour is never the only sign: `period` is a whole number of pixels. */
const hatched = (x: number, y: number, period: number) => (x + y) % period < period / 4;
const crossed = (x: number, y: number, period: number) =>
  (x + y) % period < 1.5 || (x - y + 64 * period) % period < 1.5;
const dotted = (x: number, y: number, period: number) => x % period < period / 3 && y % period < period / 3;

/**
 * RGBA, `size` x `size`, the highest v on top; both ends of each axis are samples, so the outermost ones own half a
 * cell. `scale` is device pixels a CSS pixel: patterns keep their size on fine screens.
 */
export function paint(
  field: LocusResult,
  size: number,
  style: LocusStyle,
  scale = 1,
): Uint8ClampedArray<ArrayBuffer> {
  const { width, height, state, gap } = field;
  const from = fillIn(field);
  const pixels = new Uint8ClampedArray(4 * size * size);
  const period = Math.max(4, Math.round(8 * scale));
  const shade = (at: number) => 255 * shadeOf(gap[at] ?? 0);
  const columns = axis(size, width);
  const rows = axis(size, height);
  for (let y = 0; y < size; y++) {
    const row = rows[size - 1 - y] ?? { near: 0, low: 0, part: 0 };
    for (let x = 0; x < size; x++) {
      const column = columns[x] ?? row;
      const at = from[row.near * width + column.near] ?? -1;
      if (at < 0) continue;
      let colour: Rgb = HOLDS;
      switch (state[at]) {
        case STATE.disconnected:
          if (style === "yesno") {
            colour = hatched(x, y, period) ? (SHADES[40] ?? BROKEN) : BROKEN;
          } else {
            colour = SHADES[Math.round(smooth(field, from, row, column, shade) ?? shade(at))] ?? BROKEN;
          }
          break;
        case STATE.undecided:
          colour = dotted(x, y, period) ? NONE : UNDECIDED;
          break;
        case STATE.none:
          colour = crossed(x, y, period) ? UNDECIDED : NONE;
          break;
      }
      const i = 4 * (y * size + x);
      pixels[i] = colour[0];
      pixels[i + 1] = colour[1];
      pixels[i + 2] = colour[2];
      pixels[i + 3] = 255;
    }
  }
  return pixels;
}

interface Place {
  /** The nearest sample. */
  near: number;
  /** The sample at or below, and how far on to the next one. */
  low: number;
  part: number;
}

/** Where the middle of each pixel falls among the samples of an axis. */
function axis(size: number, samples: number): Place[] {
  return Array.from({ length: size }, (_, i) => {
    const at = ((i + 0.5) / size) * (samples - 1);
    const low = Math.max(0, Math.min(samples - 2, Math.floor(at)));
    return { near: Math.round(at), low, part: at - low };
  });
}

/** The shade between four samples, or null where one of them is not broken: the border stays as sharp as it is known. */
function smooth(
  { width, height, state }: LocusResult,
  from: Int32Array,
  row: Place,
  column: Place,
  shade: (at: number) => number,
): number | null {
  if (width < 2 || height < 2) return null;
  const corner = row.low * width + column.low;
  const at = [corner, corner + 1, corner + width, corner + width + 1].map((i) => from[i] ?? -1);
  if (at.some((i) => state[i] !== STATE.disconnected)) return null;
  const [p = 0, q = 0, r = 0, s = 0] = at.map(shade);
  const low = p + column.part * (q - p);
  const high = r + column.part * (s - r);
  return low + row.part * (high - low);
}
