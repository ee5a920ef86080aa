/** A leaf as a picture without an edge: its colours go on outside, so that nothing of the ground is seen beside it. */

export interface Texture {
  /** Red, green, blue and alpha, row after row from the top. */
  data: Uint8ClampedArray;
  width: number;
  height: number;
  /** Where it lies in the plane: left, bottom, right, top. */
  box: readonly [number, number, number, number];
}

/**
 * Fills what is transparent with the colours around it, which are averaged ever more coarsely the farther they are, as
 * in Gortler, Grzeszczuk, Szeliski & Cohen, “The lumigraph”, 1996 (pull and push). What there is in `whole` stays as it
 * is there: more of the same picture, whose rim is no colour to go on with.
 */
export function filled({ data, width, height }: ImageData, whole: Uint8ClampedArray): Uint8ClampedArray {
  const colours = new Float32Array(4 * width * height);
  for (let i = 0; i < data.length; i += 4) {
    const weight = (data[i + 3] ?? 0) / 255;
    for (let k = 0; k < 3; k++) colours[i + k] = weight * (data[i + k] ?? 0);
    colours[i + 3] = weight;
  }
  push(colours, width, height);
  const out = new Uint8ClampedArray(data.length);
  for (let i = 0; i < out.length; i++) {
    const part = (whole[i | 3] ?? 0) / 255;
    out[i] = i % 4 === 3 ? 255 : (colours[i] ?? 0) * (1 - part) + (whole[i] ?? 0) * part;
  }
  return out;
}

/** Colours times their weights, and weights: all have weight 1 afterwards, unless none has any. */
function push(colours: Float32Array, width: number, height: number): void {
  if (width === 1 && height === 1) {
    scaleTo(colours, 0, 1);
    return;
  }
  const [across, down] = [Math.ceil(width / 2), Math.ceil(height / 2)];
  const coarse = new Float32Array(4 * across * down);
  const under = (x: number, y: number) => 4 * ((y >> 1) * across + (x >> 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [i, j] = [4 * (y * width + x), under(x, y)];
      for (let k = 0; k < 4; k++) coarse[j + k] = (coarse[j + k] ?? 0) + (colours[i + k] ?? 0);
    }
  }
  for (let j = 0; j < coarse.length; j += 4) scaleTo(coarse, j, Math.min(1, coarse[j + 3] ?? 0));
  push(coarse, across, down);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [i, j] = [4 * (y * width + x), under(x, y)];
      const rest = 1 - (colours[i + 3] ?? 0);
      if (rest > 0)
        for (let k = 0; k < 4; k++) colours[i + k] = (colours[i + k] ?? 0) + rest * (coarse[j + k] ?? 0);
    }
  }
}

/** The same colour with another weight. */
function scaleTo(colours: Float32Array, i: number, weight: number): void {
  const before = colours[i + 3] ?? 0;
  if (before <= 0) return;
  for (let k = 0; k < 4; k++) colours[i + k] = ((colours[i + k] ?? 0) * weight) / before;
}
