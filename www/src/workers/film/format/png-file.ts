/** A PNG written row by row, so that a picture may be larger than what memory holds at a time. */
import { chunkBytes, joined, PNG_SIGNATURE } from "../../image/png";

export interface PngSettings {
  width: number;
  height: number;
  /** Without transparency: three bytes a pixel. */
  opaque: boolean;
  /** The address that the picture carries, so that Frond opens it as the document; none: null. */
  link: string | null;
}

/** What the link stands under. */
const KEYWORD = "Frond link";
/** Bytes of picture data in a chunk. */
const CHUNK = 1 << 18;

export class PngFile {
  readonly #settings: PngSettings;
  readonly #channels: 3 | 4;
  readonly #writer: WritableStreamDefaultWriter<BufferSource>;
  readonly #packed: Promise<Uint8Array<ArrayBuffer>>;
  /** The row before, as bytes. */
  #above: Uint8Array<ArrayBuffer>;
  #rows = 0;

  constructor(settings: PngSettings) {
    this.#settings = settings;
    this.#channels = settings.opaque ? 3 : 4;
    this.#above = new Uint8Array(settings.width * this.#channels);
    const packer = new CompressionStream("deflate");
    this.#writer = packer.writable.getWriter();
    this.#packed = new Response(packer.readable).arrayBuffer().then((buffer) => new Uint8Array(buffer));
    // Who never asks for the end hears of nothing.
    this.#packed.catch(() => {});
  }

  /** The next rows, RGBA from the top. */
  async add(pixels: Uint8ClampedArray): Promise<void> {
    const { width, height } = this.#settings;
    const rows = pixels.length / (4 * width);
    if (!Number.isInteger(rows) || this.#rows + rows > height)
      throw new Error("These are no rows of the picture.");
    const stride = width * this.#channels;
    const filtered = new Uint8Array(rows * (stride + 1));
    for (let row = 0; row < rows; row++) {
      const bytes = this.#bytes(pixels.subarray(4 * width * row, 4 * width * (row + 1)));
      writeRow(
        filtered.subarray(row * (stride + 1), (row + 1) * (stride + 1)),
        bytes,
        this.#above,
        this.#channels,
      );
      this.#above = bytes;
    }
    this.#rows += rows;
    await this.#writer.write(filtered);
  }

  async finish(): Promise<Uint8Array<ArrayBuffer>> {
    const { width, height, opaque, link } = this.#settings;
    if (this.#rows !== height) throw new Error("The picture is not whole.");
    await this.#writer.close();
    const packed = await this.#packed;
    const head = new Uint8Array(13);
    const view = new DataView(head.buffer);
    view.setUint32(0, width);
    view.setUint32(4, height);
    // 8 bits a channel; colours, with or without transparency.
    head.set([8, opaque ? 2 : 6], 8);
    const parts = [Uint8Array.from(PNG_SIGNATURE), chunkBytes({ type: "IHDR", data: head })];
    if (link !== null) parts.push(chunkBytes({ type: "iTXt", data: linkData(link) }));
    for (let at = 0; at < packed.length; at += CHUNK) {
      parts.push(chunkBytes({ type: "IDAT", data: packed.subarray(at, at + CHUNK) }));
    }
    parts.push(chunkBytes({ type: "IEND", data: new Uint8Array() }));
    return joined(parts);
  }

  #bytes(row: Uint8ClampedArray): Uint8Array<ArrayBuffer> {
    if (this.#channels === 4) return Uint8Array.from(row);
    const bytes = new Uint8Array((row.length / 4) * 3);
    for (let i = 0, k = 0; i < row.length; i += 4, k += 3) {
      bytes[k] = row[i] ?? 0;
      bytes[k + 1] = row[i + 1] ?? 0;
      bytes[k + 2] = row[i + 2] ?? 0;
    }
    return bytes;
  }
}

/** Not packed, in no language, under its own word only. */
function linkData(link: string): Uint8Array {
  return new TextEncoder().encode(`${KEYWORD}\0\0\0\0\0${link}`);
}

/** How a row is written: as it is, less its left neighbour, or less the one above. */
const FILTERS = [0, 1, 2] as const;

/** Writes the row by the filter that leaves the least, as the specification advises (section 12.7). */
function writeRow(into: Uint8Array, row: Uint8Array, above: Uint8Array, channels: number): void {
  const before = (filter: number, i: number) => {
    if (filter === 0) return 0;
    return (filter === 1 ? (i < channels ? 0 : row[i - channels]) : above[i]) ?? 0;
  };
  let least = Number.POSITIVE_INFINITY;
  let best = 0;
  for (const filter of FILTERS) {
    let sum = 0;
    for (let i = 0; i < row.length && sum < least; i++) {
      const left = ((row[i] ?? 0) - before(filter, i)) & 255;
      sum += left < 128 ? left : 256 - left;
    }
    if (sum < least) {
      least = sum;
      best = filter;
    }
  }
  into[0] = best;
  for (let i = 0; i < row.length; i++) into[i + 1] = (row[i] ?? 0) - before(best, i);
}
