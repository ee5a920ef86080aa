/** Paints a locus as the paper prints it: white where the shape holds together. */

import type { LocusResult } from "#compute/results";
import { STATE } from "#geometry/states";
import { HOLDS, NONE, type Rgb, ramp, shadeOf } from "#style/ramp";

export { HOLDS };
/** From the narrowest gap that counts to one as wide as the shape. */
export const NARROW: Rgb = ramp(0);
export const WIDE: Rgb = ramp(1);
const NO_SHAPE: Rgb = NONE;

/** How dark a relative gap is drawn, 0 to 1, by its logarithm. */
export const shade = (gap: number): number => shadeOf(gap);

export function colourOf(state: number, gap: number): readonly [number, number, number, number] {
  switch (state) {
    case STATE.connected:
    case STATE.touching:
    case STATE.hidden:
      return [...HOLDS, 255];
    case STATE.disconnected:
      return [...ramp(shade(gap)), 255];
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
