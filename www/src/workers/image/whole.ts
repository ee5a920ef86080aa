import type { Header } from "./header";

/**
 * Whether the end of a picture is there: decoders paint grey what is missing, or nothing. What stands behind the end,
 * as the films that telephones put there, does not count.
 */
export function isWhole(kind: Header["kind"], bytes: Uint8Array): boolean {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (kind === "jpeg") return jpeg(data, bytes);
  if (kind === "png") return png(data);
  if (kind === "webp") return bytes.length >= 12 && data.getUint32(4, true) + 8 <= bytes.length;
  return true;
}

/** Segment after segment to where the lines begin; there the only FF D9 is the end. */
function jpeg(data: DataView, bytes: Uint8Array): boolean {
  let at = 2;
  while (at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== 0xda) {
    at += bytes[at + 1] === 0xff ? 1 : 2 + Math.max(2, data.getUint16(at + 2));
  }
  for (at = bytes.indexOf(0xff, at); at >= 0; at = bytes.indexOf(0xff, at + 1)) {
    if (bytes[at + 1] === 0xd9) return true;
  }
  return false;
}

/** Chunk after chunk to the one named IEND. */
function png(data: DataView): boolean {
  let at = 8;
  while (at + 8 <= data.byteLength) {
    if (data.getUint32(at + 4) === 0x49454e44) return true;
    at += 12 + data.getUint32(at);
  }
  return false;
}
