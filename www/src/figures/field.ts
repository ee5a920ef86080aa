/** Paints a locus as the paper prints it: white where the shape holds together. */
import { STATE } from "../engine/breaks";
import type { LocusResult } from "../engine/results";

type Rgb = readonly [number, number, number];

export const HOLDS: Rgb = [250, 248, 242];
/** From the narrowest gap that counts to one as wide as the shape. */
export const NARROW: Rgb = [128, 92, 150];
export const WIDE: Rgb = [18, 19, 46];
export const NO_SHAPE: Rgb = [120, 120, 126];
const NARROWEST = 1 / 600;

/** How dark a relative gap is drawn, 0 to 1, by its logarithm. */
export function shade(gap: number): number {
  if (!(gap > NARROWEST)) return 0;
  return Math.min(1, Math.log(gap / NARROWEST) / Math.log(1 / NARROWEST));
}

export function colourOf(state: number, gap: number): readonly [number, number, number, number] {
  switch (state) {
    case STATE.connected:
    case STATE.touching:
      return [...HOLDS, 255];
    case STATE.disconnected: {
      const k = shade(gap);
      const mix = (i: 0 | 1 | 2) => Math.round(NARROW[i] + k * (WIDE[i] - NARROW[i]));
      return [mix(0), mix(1), mix(2), 255];
    }
    case STATE.none:
    case STATE.undecided:
      return [...NO_SHAPE, 255];
    default:
      return [0, 0, 0, 0];
  }
}

/** One pixel a sample, the highest v on top. */
export function fieldPixels({ width, height, state, gap }: LocusResult): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const from = (height - 1 - row) * width + column;
      pixels.set(colourOf(state[from] ?? STATE.pending, gap[from] ?? 0), 4 * (row * width + column));
    }
  }
  return pixels;
}
