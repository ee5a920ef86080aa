/** A picture of half the width and half the height: each pixel is the mean of four, RGBA with straight alpha. */
export function halved(
  pixels: Uint8ClampedArray,
  width: number,
  height: number,
): Uint8ClampedArray<ArrayBuffer> {
  const made = new Uint8ClampedArray(width * height);
  const row = 4 * width;
  for (let y = 0, k = 0; y < height; y += 2) {
    for (let x = 0; x < width; x += 2, k += 4) {
      const first = y * row + 4 * x;
      let [red, green, blue, alpha] = [0, 0, 0, 0];
      for (const i of [first, first + 4, first + row, first + row + 4]) {
        const part = pixels[i + 3] ?? 0;
        // What is clear has no colour.
        red += part * (pixels[i] ?? 0);
        green += part * (pixels[i + 1] ?? 0);
        blue += part * (pixels[i + 2] ?? 0);
        alpha += part;
      }
      if (alpha === 0) continue;
      made[k] = red / alpha;
      made[k + 1] = green / alpha;
      made[k + 2] = blue / alpha;
      made[k + 3] = alpha / 4;
    }
  }
  return made;
}
