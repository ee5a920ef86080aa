/** Frames that are files of their own: their names, and whether one that is there is the one that is wanted. */
import { groundData, linkData, type PngSettings } from "#workers/film/format/png-rows";
import { chunkBytes, chunksOf } from "#workers/image/png";

/** x.png: x-0001.png, x-0002.png .. for frames 0, 1 .. */
export const frameFile = (out: string, i: number) => {
  const number = String(i + 1).padStart(4, "0");
  return /\.[a-z]+$/i.test(out) ? out.replace(/(?=\.[a-z]+$)/i, `-${number}`) : `${out}-${number}`;
};

/** Whether a file is a whole PNG of this size that says it shows the same, before the same. */
export function isSame(
  file: Uint8Array,
  { width, height, opaque, link, ground = null }: PngSettings,
): boolean {
  const chunks = chunksOf(file);
  const head = chunks[0];
  if (head?.type !== "IHDR" || head.data.length !== 13 || chunks.at(-1)?.type !== "IEND") return false;
  const view = new DataView(head.data.buffer, head.data.byteOffset, 13);
  if (view.getUint32(0) !== width || view.getUint32(4) !== height) return false;
  if (head.data[9] !== (opaque ? 2 : 6)) return false;
  const data = (wanted: string) => chunks.find(({ type }) => type === wanted)?.data ?? new Uint8Array();
  if (!equal(data("iTXt"), linkData(link ?? ""))) return false;
  if (!equal(data("bKGD"), opaque && ground !== null ? groundData(ground) : new Uint8Array())) return false;
  // Each chunk with its check, one after the other.
  let at = 8;
  for (const chunk of chunks) {
    const bytes = chunkBytes(chunk);
    if (!equal(bytes, file.subarray(at, at + bytes.length))) return false;
    at += bytes.length;
  }
  return at === file.length;
}

const equal = (a: Uint8Array, b: Uint8Array) => a.length === b.length && a.every((byte, i) => byte === b[i]);
