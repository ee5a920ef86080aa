import { joined } from "../../image/png";
import { stillOf } from "../still";
import type { FrameSize, Sink } from "./sink";

/** Every frame as a PNG of its own, in one ZIP file: frame-0001.png and on. */
export async function zipSink(size: FrameSize & { ground: string | null }): Promise<Sink> {
  const { Zip, ZipPassThrough } = await import("fflate");
  const still = stillOf(size, size.ground !== null);
  const parts: Uint8Array[] = [];
  const zip = new Zip((problem, part) => {
    if (problem) throw problem;
    parts.push(part);
  });
  let frame = 0;
  return {
    async add(pixels) {
      // Pictures are packed already.
      const file = new ZipPassThrough(frameName(++frame));
      zip.add(file);
      file.push(await still(pixels), true);
    },
    async finish() {
      zip.end();
      return joined(parts);
    },
    async drop() {
      zip.terminate();
    },
  };
}

/** In the order of their numbers wherever they are sorted. */
export const frameName = (frame: number): string => `frame-${String(frame).padStart(4, "0")}.png`;
