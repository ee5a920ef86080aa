/** The parts of a PNG file that every way of packing it shares: filtered rows, and the chunks around what was packed. */
import { chunkBytes, joined, PNG_SIGNATURE } from "../../image/png";
import { channels } from "../opaque";

export interface PngSettings {
  width: number;
  height: number;
  /** Without transparency: three bytes a pixel. */
  opaque: boolean;
  /** The address that the picture carries, so that Frond opens it as the document; none: null. */
  link: string | null;
  /** "#rrggbb": what an opaque picture was laid on, where that is to be told. */
  ground?: string | null;
}

/** What the link stands under. */
const KEYWORD = "Frond link";
/** Bytes of picture data in a chunk. */
const CHUNK = 1 << 18;

/** The file, of filtered rows that were packed as zlib does. */
export function pngOf({ width, height, opaque, link, ground = null }: PngSettings, packed: Uint8Array) {
  const head = new Uint8Array(13);
  const view = new DataView(head.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  // 8 bits a channel; colours, with or without transparency.
  head.set([8, opaque ? 2 : 6], 8);
  const parts = [Uint8Array.from(PNG_SIGNATURE), chunkBytes({ type: "IHDR", data: head })];
  if (opaque && ground !== null) parts.push(chunkBytes({ type: "bKGD", data: groundData(ground) }));
  if (link !== null) parts.push(chunkBytes({ type: "iTXt", data: linkData(link) }));
  for (let at = 0; at < packed.length; at += CHUNK) {
    parts.push(chunkBytes({ type: "IDAT", data: packed.subarray(at, at + CHUNK) }));
  }
  parts.push(chunkBytes({ type: "IEND", data: new Uint8Array() }));
  return joined(parts);
}

/** Not packed, in no language, under its own word only. */
export function linkData(link: string): Uint8Array {
  return new TextEncoder().encode(`${KEYWORD}\0\0\0\0\0${link}`);
}

/** Two bytes a channel, whatever the depth of the picture. */
export const groundData = (ground: string) =>
  Uint8Array.from(channels(ground).flatMap((channel) => [0, channel]));

/** Writes the rows of a picture one after the other, each by the filter that suits it. */
export class RowFilter {
  readonly #stride: number;
  readonly #channels: 3 | 4;
  readonly #width: number;
  /** The row before, as bytes. */
  readonly #above: Uint8Array<ArrayBuffer>;

  constructor({ width, opaque }: Pick<PngSettings, "width" | "opaque">) {
    this.#width = width;
    this.#channels = opaque ? 3 : 4;
    this.#stride = width * this.#channels;
    this.#above = new Uint8Array(this.#stride);
  }

  /** The next rows, RGBA from the top: each begins with the number of its filter. */
  filtered(pixels: Uint8ClampedArray): Uint8Array<ArrayBuffer> {
    const stride = this.#stride;
    const rows = pixels.length / (4 * this.#width);
    const made = new Uint8Array(rows * (stride + 1));
    const row = new Uint8Array(stride);
    for (let y = 0; y < rows; y++) {
      const from = pixels.subarray(4 * this.#width * y, 4 * this.#width * (y + 1));
      if (this.#channels === 4) row.set(from);
      else withoutAlpha(from, row);
      const into = made.subarray(y * (stride + 1), (y + 1) * (stride + 1));
      writeRow(into, row, this.#above, this.#channels);
      this.#above.set(row);
    }
    return made;
  }
}

function withoutAlpha(pixels: Uint8ClampedArray, row: Uint8Array): void {
  for (let i = 0, k = 0; k < row.length; i += 4, k += 3) {
    row[k] = pixels[i] as number;
    row[k + 1] = pixels[i + 1] as number;
    row[k + 2] = pixels[i + 2] as number;
  }
}

/**
 * Writes a row as it is (0), less its left neighbour (1) or less the one above (2): the filter that leaves the least,
 * as the specification advises (section 12.7), and of equals the first. `into` is all zeros before.
 */
function writeRow(into: Uint8Array, row: Uint8Array, above: Uint8Array, channels: number): void {
  const length = row.length;
  // Most rows of many pictures are clear, or like the row above: the sums below would say the same.
  if (same(row, above)) {
    into[0] = blank(row) ? 0 : 2;
    return;
  }
  let [plain, left, up] = [0, 0, 0];
  for (let i = 0; i < channels; i++) {
    plain += SIZE[row[i] as number] as number;
    up += SIZE[((row[i] as number) - (above[i] as number)) & 255] as number;
  }
  left = plain;
  for (let i = channels; i < length; i++) {
    const byte = row[i] as number;
    plain += SIZE[byte] as number;
    left += SIZE[(byte - (row[i - channels] as number)) & 255] as number;
    up += SIZE[(byte - (above[i] as number)) & 255] as number;
  }
  const filter = plain <= left && plain <= up ? 0 : left <= up ? 1 : 2;
  into[0] = filter;
  if (filter === 0) into.set(row, 1);
  else if (filter === 2) {
    for (let i = 0; i < length; i++) into[i + 1] = (row[i] as number) - (above[i] as number);
  } else {
    into.set(row.subarray(0, channels), 1);
    for (let i = channels; i < length; i++) into[i + 1] = (row[i] as number) - (row[i - channels] as number);
  }
}

/** How far a difference of bytes is from nothing, whichever way round. */
const SIZE = Uint8Array.from({ length: 256 }, (_, byte) => Math.min(byte, 256 - byte));

function same(row: Uint8Array, above: Uint8Array): boolean {
  for (let i = 0; i < row.length; i++) if (row[i] !== above[i]) return false;
  return true;
}

function blank(row: Uint8Array): boolean {
  for (let i = 0; i < row.length; i++) if (row[i] !== 0) return false;
  return true;
}
