/** Frames as codecs take them: a plane of brightness and two of colour, by Rec. ITU-R BT.709, in its limited range. */

/** Whether each pixel has a colour of its own, or four share one. */
export type Chroma = "420" | "444";

/** Colours are those of the page. What says so travels in the file: players would otherwise guess. */
export const COLOUR_SPACE = {
  primaries: "bt709",
  transfer: "iec61966-2-1",
  matrix: "bt709",
  fullRange: false,
} as const;

/** BT.709, item 3.2: what of red and blue brightness has; the rest is green. */
const RED = 0.2126;
const BLUE = 0.0722;
const GREEN = 1 - RED - BLUE;
/** Of 8 bits (item 4.6): brightness is 16 to 235, colour 16 to 240. */
const BRIGHT = 219 / 255;
const HUE = 224 / 255;
const CB = HUE / (2 * (1 - BLUE));
const CR = HUE / (2 * (1 - RED));

/** Of RGBA pixels, whose alpha does not count: the planes one after the other. Both sides are even. */
export function planesOf(
  pixels: Uint8ClampedArray,
  width: number,
  height: number,
  chroma: Chroma,
): Uint8Array<ArrayBuffer> {
  const side = chroma === "444" ? 1 : 2;
  const [across, down] = [width / side, height / side];
  const made = new Uint8Array(width * height + 2 * across * down);
  // Stores round half up: no value is outside its range.
  for (let i = 0, k = 0; k < width * height; i += 4, k++) {
    const y = RED * (pixels[i] ?? 0) + GREEN * (pixels[i + 1] ?? 0) + BLUE * (pixels[i + 2] ?? 0);
    made[k] = 16.5 + BRIGHT * y;
  }
  const [first, second] = [width * height, width * height + across * down];
  const part = 1 / (side * side);
  for (let row = 0, k = 0; row < down; row++) {
    for (let column = 0; column < across; column++, k++) {
      let [red, green, blue] = [0, 0, 0];
      for (let y = side * row; y < side * (row + 1); y++) {
        for (let i = 4 * (y * width + side * column), end = i + 4 * side; i < end; i += 4) {
          red += pixels[i] ?? 0;
          green += pixels[i + 1] ?? 0;
          blue += pixels[i + 2] ?? 0;
        }
      }
      const bright = RED * red + GREEN * green + BLUE * blue;
      made[first + k] = 128.5 + CB * part * (blue - bright);
      made[second + k] = 128.5 + CR * part * (red - bright);
    }
  }
  return made;
}
