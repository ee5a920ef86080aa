/** Lays a picture with straight alpha on a ground, in place: films are opaque. */
export function layOn(pixels: Uint8ClampedArray, ground: string): void {
  const [red, green, blue] = channels(ground);
  for (let i = 0; i < pixels.length; i += 4) {
    const alpha = (pixels[i + 3] ?? 0) / 255;
    if (alpha === 1) continue;
    pixels[i] = (pixels[i] ?? 0) * alpha + red * (1 - alpha);
    pixels[i + 1] = (pixels[i + 1] ?? 0) * alpha + green * (1 - alpha);
    pixels[i + 2] = (pixels[i + 2] ?? 0) * alpha + blue * (1 - alpha);
    pixels[i + 3] = 255;
  }
}

/** Of "#rrggbb", 0 to 255. */
export function channels(colour: string): [red: number, green: number, blue: number] {
  const value = Number.parseInt(colour.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}
