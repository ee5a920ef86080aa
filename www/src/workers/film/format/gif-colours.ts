/** The colours of a GIF: which ones it has, which of them each pixel gets, and whether dots are to mix more. */

export type Colour = readonly [red: number, green: number, blue: number];

/** Of all pixels seen, a colour with this part is one of a flat picture: it is kept exactly. */
const FLAT = 1 / 500;
const MOST_FLAT = 96;
/** Root mean square distance, of 255 a channel, from where on stripes are seen where a colour runs into another. */
const ROUGH = 2;

export interface Palette {
  colours: readonly Colour[];
  /** Whether it is so far from what was seen that mixing its colours from dots looks better. */
  rough: boolean;
}

/**
 * At most `most` colours for such pixels, RGBA, all of them opaque; `ground` is one of them. A few colours are kept
 * exactly, as those of flat pictures are; more are chosen by `quantize`.
 */
export function paletteOf(
  pixels: Uint8ClampedArray,
  ground: Colour | null,
  most: number,
  quantize: (rgba: Uint8ClampedArray, colours: number) => number[][],
): Palette {
  const counts = countsOf(pixels);
  const behind = ground === null ? null : packed(...ground);
  if (behind !== null) counts.delete(behind);
  const first = ground === null ? [] : [ground];
  const room = most - first.length;
  if (counts.size <= room) return { colours: [...first, ...[...counts.keys()].map(unpacked)], rough: false };
  let seen = 0;
  for (const count of counts.values()) seen += count;
  const flat = [...counts]
    .filter(([, count]) => count >= FLAT * seen)
    .sort(([, p], [, q]) => q - p)
    .slice(0, Math.min(MOST_FLAT, room - 1))
    .map(([colour]) => colour);
  const exact = new Set(flat);
  if (behind !== null) exact.add(behind);
  const rest = pixels.filter((_, i) => !exact.has(packedAt(pixels, i - (i % 4))));
  const more = quantize(rest, room - flat.length).slice(0, room - flat.length);
  const colours = [
    ...first,
    ...flat.map(unpacked),
    ...more.map(([r = 0, g = 0, b = 0]): Colour => [r, g, b]),
  ];
  const nearest = matcher(colours);
  let sum = 0;
  for (const [colour, count] of counts) {
    const [r, g, b] = unpacked(colour);
    const [x, y, z] = colours[nearest(r, g, b)] ?? [0, 0, 0];
    sum += count * ((r - x) ** 2 + (g - y) ** 2 + (b - z) ** 2);
  }
  return { colours, rough: Math.sqrt(sum / seen) > ROUGH };
}

/**
 * Says which colour is nearest. Those of the palette are themselves; others are told apart as finely as 64 steps a
 * channel, and the same in every frame, so that nothing shimmers.
 */
export function matcher(colours: readonly Colour[]): (red: number, green: number, blue: number) => number {
  const own = new Map<number, number>();
  for (const [i, colour] of colours.entries()) if (!own.has(packed(...colour))) own.set(packed(...colour), i);
  const known = new Int16Array(1 << 18).fill(-1);
  const search = (r: number, g: number, b: number) => {
    let [best, least] = [0, Number.POSITIVE_INFINITY];
    for (let i = 0; i < colours.length; i++) {
      const [x, y, z] = colours[i] as Colour;
      const far = (r - x) ** 2 + (g - y) ** 2 + (b - z) ** 2;
      if (far < least) [best, least] = [i, far];
    }
    return best;
  };
  return (red, green, blue) => {
    const exact = own.get(packed(red, green, blue));
    if (exact !== undefined) return exact;
    const key = ((red >> 2) << 12) | ((green >> 2) << 6) | (blue >> 2);
    const before = known[key] ?? -1;
    if (before >= 0) return before;
    const found = search((red & 252) + 1.5, (green & 252) + 1.5, (blue & 252) + 1.5);
    known[key] = found;
    return found;
  };
}

/** The index of each pixel, RGBA. */
export function indexed(
  pixels: Uint8ClampedArray,
  nearest: ReturnType<typeof matcher>,
): Uint8Array<ArrayBuffer> {
  const index = new Uint8Array(pixels.length / 4);
  let [last, found] = [-1, 0];
  for (let i = 0; i < index.length; i++) {
    const colour = packedAt(pixels, 4 * i);
    // Neighbours are mostly alike.
    if (colour !== last) {
      last = colour;
      found = nearest(colour >> 16, (colour >> 8) & 255, colour & 255);
    }
    index[i] = found;
  }
  return index;
}

function countsOf(pixels: Uint8ClampedArray): Map<number, number> {
  const counts = new Map<number, number>();
  for (let i = 0; i < pixels.length; i += 4) {
    const colour = packedAt(pixels, i);
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  return counts;
}

const packed = (red: number, green: number, blue: number): number => (red << 16) | (green << 8) | blue;
const packedAt = (pixels: Uint8ClampedArray, i: number): number =>
  packed(pixels[i] ?? 0, pixels[i + 1] ?? 0, pixels[i + 2] ?? 0);
const unpacked = (colour: number): Colour => [colour >> 16, (colour >> 8) & 255, colour & 255];
