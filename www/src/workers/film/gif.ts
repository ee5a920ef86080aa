import { channels } from "./opaque";
import type { FrameSize, Sink } from "./sink";

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
  samples,
}: FrameSize & { ground: string; samples: Uint8ClampedArray }): Promise<Sink> {
  const { GIFEncoder, applyPalette, quantize } = await import("gifenc");
  const gif = GIFEncoder();
  // The ground is most of many pictures: it is exactly what it is on the page.
  const palette = [channels(ground), ...quantize(samples, COLOURS - 1).slice(0, COLOURS - 1)];
  const table = [...palette];
  while (table.length <= SAME) table.push([0, 0, 0]);
  let before: Uint8Array | null = null;
  let frame = 0;
  return {
    async add(pixels) {
      const index = applyPalette(pixels, palette);
      const written = before ? changesSince(before, index) : index;
      const delay = 10 * gifDelay(frame, fps);
      const first = before === null;
      gif.writeFrame(written, width, height, {
        delay,
        dispose: 1,
        ...(first ? { palette: table, repeat: 0 } : { transparent: true, transparentIndex: SAME }),
      });
      before = index;
      frame++;
    },
    async finish() {
      gif.finish();
      return gif.bytes();
    },
    async drop() {},
  };
}

/** The frame where it differs from the one before; elsewhere nothing, which takes little room. */
export function changesSince(before: Uint8Array, now: Uint8Array): Uint8Array {
  return now.map((colour, i) => (colour === before[i] ? SAME : colour));
}
