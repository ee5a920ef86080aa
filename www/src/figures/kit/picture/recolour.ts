/** A picture in the colours of one palette, at once in those of another: for paper, where nothing can be waited for. */
import { palette } from "#style/palette";

type Colour = readonly [red: number, green: number, blue: number];

const parsed = (colours: readonly string[]) =>
  colours.map((colour): Colour => {
    const value = Number.parseInt(colour.slice(1), 16);
    return [value >> 16, (value >> 8) & 255, value & 255];
  });

/** As near to a colour of the palette as rounding leaves it. */
const NEAR = 12;

/** Changes red, green, blue and alpha of each pixel whose colour is one of `from` to that of `to`; no others. */
export function recolour(pixels: Uint8ClampedArray, from: readonly string[], to: readonly string[]): void {
  const [before, after] = [parsed(from), parsed(to)];
  for (let i = 0; i + 3 < pixels.length; i += 4) {
    if (pixels[i + 3] === 0) continue;
    const [r = 0, g = 0, b = 0] = pixels.subarray(i, i + 3);
    let [best, least] = [-1, NEAR * NEAR];
    before.forEach(([x, y, z], at) => {
      const far = (x - r) ** 2 + (y - g) ** 2 + (z - b) ** 2;
      if (far < least) [best, least] = [at, far];
    });
    const colour = after[best];
    if (colour) pixels.set(colour, i);
  }
}

/** A picture that was drawn for a dark page, as it is on a light one. */
export function lighten(canvas: HTMLCanvasElement): void {
  const { width, height } = canvas;
  const context = canvas.getContext("2d");
  if (!context || width * height === 0) return;
  const image = context.getImageData(0, 0, width, height);
  recolour(image.data, palette("dark"), palette("light"));
  context.putImageData(image, 0, 0);
}
