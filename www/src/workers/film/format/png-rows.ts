/** What every way of packing a PNG shares: filtered rows, and the chunks around what was packed. */
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
    const across = 4 * this.#width;
    const rows = pixels.length / across;
    const made = new Uint8Array(rows * (stride + 1));
    let above = this.#above;
    let [row, other] = [new Uint8Array(stride), new Uint8Array(stride)];
    for (let y = 0; y < rows; y++) {
      const from = pixels.subarray(across * y, across * (y + 1));
      if (this.#channels === 4) row.set(from);
      else withoutAlpha(from, row);
      writeRow(made.subarray(y * (stride + 1), (y + 1) * (stride + 1)), row, above, this.#channels);
      above = row;
      [row, other] = [other, row];
    }
    this.#above.set(above);
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
  // What is clear in both rows, as the margins of many pictures are, leaves nothing by any filter.
  let from = 0;
  let to = row.length;
  while (from < to && row[from] === 0 && above[from] === 0) from++;
  while (to > from && row[to - 1] === 0 && above[to - 1] === 0) to--;
  to = Math.min(row.length, to + channels);
  let [plain, left, up] = [0, 0, 0];
  for (let i = from; i < to; i++) {
    const byte = row[i] as number;
    const before = i < channels ? 0 : (row[i - channels] as number);
    plain += SIZE[byte] as number;
    left += SIZE[(byte - before) & 255] as number;
    up += SIZE[(byte - (above[i] as number)) & 255] as number;
  }
  const filter = plain <= left && plain <= up ? 0 : left <= up ? 1 : 2;
  into[0] = filter;
  for (let i = from; i < to; i++) {
    const before = filter === 2 ? above[i] : filter === 1 && i >= channels ? row[i - channels] : 0;
    into[i + 1] = (row[i] as number) - (before as number);
  }
}

/** How far a difference of bytes is from nothing, whichever way round. */
const SIZE = Uint8Array.from({ length: 256 }, (_, byte) => Math.min(byte, 256 - byte));
