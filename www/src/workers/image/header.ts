/** What the first bytes of a file say of the picture in it, before anything is decoded. */
import { type PictureKind, signatureOf } from "./signature";

export interface Header {
  kind: PictureKind | "svg" | "unknown";
  /** What it is, where it is known and no picture that is read. */
  other?: string;
  /** Where the size can be read off: not of every AVIF. */
  size?: { width: number; height: number };
}

/** As many bytes as are looked at: sizes of JPEG files stand behind their thumbnails and colour profiles. */
export const HEAD_BYTES = 1 << 20;

/** Reads the header of a picture. Whatever the bytes are, it says `unknown` rather than throw. */
export function readHeader(bytes: Uint8Array): Header {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const text = (from: number, count: number) => latin(bytes.subarray(from, from + count));
  const signature = signatureOf(bytes);
  if (signature && "other" in signature) return { kind: "unknown", other: signature.other };
  switch (signature?.picture) {
    case "png":
      return sized("png", png(data));
    case "jpeg":
      return sized("jpeg", jpeg(data));
    case "webp":
      return sized("webp", webp(data, text(12, 4)));
    case "gif":
      return sized("gif", pair(data, 6, 8, 2));
    case "avif":
      return sized("avif", avif(data, bytes));
    case "bmp":
      return sized("bmp", bmp(data));
  }
  return { kind: isSvg(text(0, 4096)) ? "svg" : "unknown" };
}

type Size = Header["size"] | null;

function sized(kind: Header["kind"], size: Size): Header {
  return size && size.width > 0 && size.height > 0 ? { kind, size } : { kind };
}

function latin(bytes: Uint8Array): string {
  return String.fromCharCode(...bytes);
}

/** Two whole numbers of so many bytes, the lowest first, if they are there. */
function pair(data: DataView, x: number, y: number, bytes: 2 | 3): Size {
  if (data.byteLength < Math.max(x, y) + bytes) return null;
  const at = (i: number) => data.getUint16(i, true) + (bytes === 3 ? data.getUint8(i + 2) * 0x10000 : 0);
  return { width: at(x), height: at(y) };
}

function bmp(data: DataView): Size {
  if (data.byteLength < 26) return null;
  return { width: data.getInt32(18, true), height: Math.abs(data.getInt32(22, true)) };
}

function png(data: DataView): Size {
  if (data.byteLength < 24) return null;
  return { width: data.getUint32(16), height: data.getUint32(20) };
}

/** Segment after segment up to the one that begins a frame. */
function jpeg(data: DataView): Size {
  let at = 2;
  while (at + 9 <= data.byteLength) {
    if (data.getUint8(at) !== 0xff) return null;
    const marker = data.getUint8(at + 1);
    if (marker === 0xff) {
      at += 1;
      continue;
    }
    // All that begin a frame: C0 to CF, but for tables (C4, CC) and an extension (C8).
    const frame = marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
    if (frame) return { height: data.getUint16(at + 5), width: data.getUint16(at + 7) };
    const alone = marker === 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += 2 + (alone ? 0 : Math.max(2, data.getUint16(at + 2)));
  }
  return null;
}

function webp(data: DataView, chunk: string): Size {
  if (chunk === "VP8X") {
    const size = pair(data, 24, 27, 3);
    return size && { width: size.width + 1, height: size.height + 1 };
  }
  if (chunk === "VP8L" && data.byteLength >= 25) {
    const bits = data.getUint32(21, true);
    return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
  }
  const size = chunk === "VP8 " ? pair(data, 26, 28, 2) : null;
  return size && { width: size.width & 0x3fff, height: size.height & 0x3fff };
}

/** The largest of the sizes that the boxes named "ispe" give: others are of thumbnails, tiles and alpha. */
function avif(data: DataView, bytes: Uint8Array): Size {
  let best: Size = null;
  for (let at = 4; at + 16 <= bytes.length; at++) {
    if (latin(bytes.subarray(at, at + 4)) !== "ispe") continue;
    const size = { width: data.getUint32(at + 8), height: data.getUint32(at + 12) };
    if (!best || size.width * size.height > best.width * best.height) best = size;
  }
  return best;
}

function isSvg(text: string): boolean {
  return /^(\xef\xbb\xbf)?\s*(<\?xml|<!--|<!doctype svg|<svg)/i.test(text) && /<svg[\s/>]/i.test(text);
}
