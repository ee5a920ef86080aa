/** A PNG written row by row, so that a picture may be larger than what memory holds at a time. */
import { type PngSettings, pngOf, RowFilter } from "./png-rows";

export type { PngSettings } from "./png-rows";

export class PngFile {
  readonly #settings: PngSettings;
  readonly #filter: RowFilter;
  readonly #writer: WritableStreamDefaultWriter<BufferSource>;
  readonly #packed: Promise<Uint8Array<ArrayBuffer>>;
  #rows = 0;

  constructor(settings: PngSettings) {
    this.#settings = settings;
    this.#filter = new RowFilter(settings);
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
    this.#rows += rows;
    await this.#writer.write(this.#filter.filtered(pixels));
  }

  async finish(): Promise<Uint8Array<ArrayBuffer>> {
    if (this.#rows !== this.#settings.height) throw new Error("The picture is not whole.");
    await this.#writer.close();
    return pngOf(this.#settings, await this.#packed);
  }
}
