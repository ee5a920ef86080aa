import { channels } from "../opaque";
import { indexed, matcher, type Palette, paletteOf } from "./gif-colours";
import type { FilmSettings, FrameSize, Sink } from "./sink";

/** One of the 256 means: as it was in the frame before. */
const COLOURS = 255;
const SAME = 255;

/** Browsers take a shorter time for a mistake and show a tenth of a second instead. */
export const MOST_GIF_FPS = 50;

/** How long each frame stands, in hundredths of a second: they add up to what they should, however many there are. */
export function gifDelay(frame: number, fps: number): number {
  return Math.round((100 * (frame + 1)) / fps) - Math.round((100 * frame) / fps);
}

/** A moving GIF that goes round and round. `samples` are pixels of some of its frames: they choose its colours. */
export async function gifSink({
  width,
  height,
  fps,
  ground,
  dither,
  samples = new Uint8ClampedArray(4),
}: Omit<FilmSettings, "kind" | "bitrate">): Promise<Sink> {
  const { colours, rough } = await gifColours(samples, ground);
  const behind = ground === null ? null : channels(ground);
  const mixes = dither ?? rough;
  const nearest = matcher(colours);
  const writer = await gifWriter({ width, height, fps, ground }, colours);
  return {
    async add(pixels) {
      writer.add(gifIndices(mixes ? dithered(pixels, width, behind) : pixels, nearest, ground));
    },
    finish: async () => writer.finish(),
    async drop() {},
  };
}

/** The colours for frames like these samples. */
export async function gifColours(samples: Uint8ClampedArray, ground: string | null): Promise<Palette> {
  const { quantize } = await import("gifenc");
  // The ground is most of many pictures: it is exactly what it is on the page.
  return paletteOf(visible(samples), ground === null ? null : channels(ground), COLOURS, quantize);
}

/** The colour of each pixel, by its number. */
export function gifIndices(
  pixels: Uint8ClampedArray,
  nearest: ReturnType<typeof matcher>,
  ground: string | null,
): Uint8Array<ArrayBuffer> {
  const index = indexed(pixels, nearest);
  // Nothing of a frame before shines through where this one is clear.
  if (ground === null) clearOf(pixels, index);
  return index;
}

/** Writes frames whose pixels are numbers of colours. */
export async function gifWriter(
  { width, height, fps, ground }: FrameSize & { ground: string | null },
  colours: Palette["colours"],
) {
  const { GIFEncoder } = await import("gifenc");
  const gif = GIFEncoder();
  const opaque = ground !== null;
  const table = colours.map((colour) => [...colour]);
  while (table.length <= SAME) table.push([0, 0, 0]);
  let before: Uint8Array | null = null;
  let frame = 0;
  return {
    add(index: Uint8Array): void {
      const written = before && opaque ? changesSince(before, index) : index;
      gif.writeFrame(written, width, height, {
        delay: 10 * gifDelay(frame, fps),
        dispose: opaque ? 1 : 2,
        ...(before === null ? { palette: table, repeat: 0 } : {}),
        ...(before === null && opaque ? {} : { transparent: true, transparentIndex: SAME }),
      });
      before = index;
      frame++;
    },
    finish() {
      gif.finish();
      return gif.bytes();
    },
  };
}

/** A pixel of a GIF is there or not: half and more is there. */
const THERE = 128;

/** What is to be seen of some pictures; at least one pixel. */
function visible(samples: Uint8ClampedArray): Uint8ClampedArray {
  const seen = new Uint8ClampedArray(samples.length);
  let at = 0;
  for (let i = 0; i < samples.length; i += 4) {
    if ((samples[i + 3] ?? 0) < THERE) continue;
    seen.set(samples.subarray(i, i + 4), at);
    at += 4;
  }
  return at > 0 ? seen.slice(0, at) : new Uint8ClampedArray(4);
}

function clearOf(pixels: Uint8ClampedArray, index: Uint8Array): void {
  for (let i = 0; i < index.length; i++) if ((pixels[4 * i + 3] ?? 0) < THERE) index[i] = SAME;
}

/** How far dots reach beyond a colour, of 255: about as far as the next colour of a palette is. */
const REACH = 24;
/** The order in which the dots of a square of 8 by 8 appear (Bayer 1973), 0 to 63. */
const BAYER = Uint8Array.from({ length: 64 }, (_, i) => {
  const [x, y] = [i & 7, i >> 3];
  let order = 0;
  for (let bit = 0; bit < 3; bit++) {
    const [p, q] = [(x >> bit) & 1, (y >> bit) & 1];
    order |= (((p ^ q) << 1) | q) << (2 * (2 - bit));
  }
  return order;
});

/**
 * Colours in between become dots of both. The dots stand still from frame to frame, which neither shimmers nor takes
 * much room; the ground has none.
 */
export function dithered(
  pixels: Uint8ClampedArray,
  width: number,
  ground: readonly [number, number, number] | null,
): Uint8ClampedArray {
  const made = new Uint8ClampedArray(pixels);
  for (let i = 0; i < made.length; i += 4) {
    if (ground?.every((channel, k) => pixels[i + k] === channel)) continue;
    const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
    const shift = REACH * (((BAYER[8 * (y & 7) + (x & 7)] ?? 0) + 0.5) / 64 - 0.5);
    for (let k = 0; k < 3; k++) made[i + k] = (pixels[i + k] ?? 0) + shift;
  }
  return made;
}

/** The frame where it differs from the one before; elsewhere nothing, which takes little room. */
export function changesSince(before: Uint8Array, now: Uint8Array): Uint8Array {
  return now.map((colour, i) => (colour === before[i] ? SAME : colour));
}
