/** A leaf as a bitmap: pixels inside and outside, and how many lie on its boundary. */

export interface Bitmap {
  width: number;
  height: number;
  /** 1 inside, 0 outside, row after row from the top. */
  inside: Uint8Array;
}

/** The paper's leaf has so many pixels on its boundary (section 4.3). */
export const PRINTED = 4068;

/** Pixels inside with a neighbour to a side outside. */
export function boundaryCount({ width, height, inside }: Bitmap): number {
  const at = (x: number, y: number) =>
    x >= 0 && y >= 0 && x < width && y < height && inside[y * width + x] === 1;
  let count = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      if (at(x, y) && !(at(x - 1, y) && at(x + 1, y) && at(x, y - 1) && at(x, y + 1))) count++;
  return count;
}

/** Free pixels round the leaf. */
const MARGIN = 8;
const [LEAST, MOST] = [64, 2000];

/** How high a leaf has to be drawn for another count of pixels on its boundary, which grows as its height does. */
export const heightFor = (height: number, count: number): number =>
  Math.min(MOST, Math.max(LEAST, Math.round((height * PRINTED) / Math.max(1, count))));

/** Which pixels have their middle inside an outline x0, y0, x1, y1, .. with y up, drawn so high: even-odd. */
export function filled(points: ArrayLike<number>, height: number): Bitmap {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x = 0, y = 0] = [points[i], points[i + 1]];
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  }
  // Nothing has no size.
  if (!(x1 >= x0)) return { width: 1, height: 1, inside: new Uint8Array(1) };
  const scale = (height - 2 * MARGIN) / Math.max(y1 - y0, 1e-9);
  const width = Math.min(MOST, Math.ceil((x1 - x0) * scale) + 2 * MARGIN);
  const inside = new Uint8Array(width * height);
  const count = points.length / 2;
  for (let row = 0; row < height; row++) {
    const y = y1 - (row + 0.5 - MARGIN) / scale;
    const crossings: number[] = [];
    for (let i = 0; i < count; i++) {
      const k = (i + 1) % count;
      const [px = 0, py = 0, qx = 0, qy = 0] = [
        points[2 * i],
        points[2 * i + 1],
        points[2 * k],
        points[2 * k + 1],
      ];
      if (py <= y === qy <= y) continue;
      crossings.push(MARGIN + (px + ((y - py) / (qy - py)) * (qx - px) - x0) * scale);
    }
    crossings.sort((p, q) => p - q);
    for (let i = 0; i + 1 < crossings.length; i += 2) {
      const from = Math.max(0, Math.ceil((crossings[i] ?? 0) - 0.5));
      const to = Math.min(width - 1, Math.floor((crossings[i + 1] ?? 0) - 0.5));
      if (to >= from) inside.fill(1, row * width + from, row * width + to + 1);
    }
  }
  return { width, height, inside };
}

/** The leaf as a bitmap with about as many pixels on its boundary as the paper's. */
export function leafBitmap(points: ArrayLike<number>): { bitmap: Bitmap; count: number } {
  let height = 800;
  let bitmap = filled(points, height);
  let count = boundaryCount(bitmap);
  for (let round = 0; round < 3 && Math.abs(count - PRINTED) > 0.005 * PRINTED; round++) {
    height = heightFor(height, count);
    bitmap = filled(points, height);
    count = boundaryCount(bitmap);
  }
  return { bitmap, count };
}
