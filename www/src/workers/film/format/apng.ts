import { chunkBytes, chunksOf, joined, PNG_SIGNATURE } from "../../image/png";
import { stillOf } from "../still";
import type { FrameSize, Sink } from "./sink";

export interface ApngFrame {
  /** Of its picture, as PNG holds it. */
  data: Uint8Array[];
  /** How many frames in a row look like this. */
  count: number;
}

/**
 * A moving PNG that goes round and round (PNG specification, third edition, sections 11.3.5): full colours, and clear
 * where it is. The browser writes each frame, and their data go into one file.
 */
export function apngSink(size: FrameSize & { ground: string | null }): Sink {
  const still = stillOf(size, size.ground !== null);
  const frames: ApngFrame[] = [];
  let head: Uint8Array | null = null;
  let before: Uint8ClampedArray | null = null;
  return {
    async add(pixels) {
      const last = frames.at(-1);
      if (last && before && same(before, pixels)) {
        last.count++;
        return;
      }
      before = pixels.slice();
      const chunks = chunksOf(await still(pixels));
      const header = chunks.find(({ type }) => type === "IHDR")?.data;
      if (!header) throw new Error("This browser cannot write PNG.");
      head ??= header;
      if (!same(head, header))
        throw new Error("The frames are of different kinds. Choose another kind of file.");
      const data = chunks.filter(({ type }) => type === "IDAT").map((chunk) => chunk.data);
      frames.push({ data, count: 1 });
    },
    async finish() {
      if (!head) throw new Error("There is no frame.");
      return apngBytes(head, frames, size);
    },
    async drop() {
      frames.length = 0;
    },
  };
}

/** The file, from the header chunk that all frames have. */
export function apngBytes(
  head: Uint8Array,
  frames: readonly ApngFrame[],
  { width, height, fps }: FrameSize,
): Uint8Array<ArrayBuffer> {
  const parts: Uint8Array[] = [Uint8Array.from(PNG_SIGNATURE), chunkBytes({ type: "IHDR", data: head })];
  // 0 times is for ever.
  parts.push(chunkBytes({ type: "acTL", data: words32(frames.length, 0) }));
  let sequence = 0;
  let shown = 0;
  for (const [i, { data, count }] of frames.entries()) {
    const control = new Uint8Array(26);
    control.set(words32(sequence++, width, height, 0, 0));
    const view = new DataView(control.buffer);
    view.setUint16(20, milliseconds(shown, count, fps));
    view.setUint16(22, 1000);
    shown += count;
    parts.push(chunkBytes({ type: "fcTL", data: control }));
    for (const piece of data) {
      parts.push(
        i === 0
          ? chunkBytes({ type: "IDAT", data: piece })
          : chunkBytes({ type: "fdAT", data: joined([words32(sequence++), piece]) }),
      );
    }
  }
  parts.push(chunkBytes({ type: "IEND", data: new Uint8Array() }));
  return joined(parts);
}

/** How long so many frames stand: they add up to what they should, however many there are. */
function milliseconds(from: number, count: number, fps: number): number {
  return Math.min(65_535, Math.round((1000 * (from + count)) / fps) - Math.round((1000 * from) / fps));
}

function words32(...words: number[]): Uint8Array {
  const bytes = new Uint8Array(4 * words.length);
  const view = new DataView(bytes.buffer);
  for (const [i, word] of words.entries()) view.setUint32(4 * i, word);
  return bytes;
}

function same(p: ArrayLike<number>, q: ArrayLike<number>): boolean {
  if (p.length !== q.length) return false;
  for (let i = 0; i < p.length; i++) if (p[i] !== q[i]) return false;
  return true;
}
