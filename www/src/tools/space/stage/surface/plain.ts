import type { Pixels } from "#stage/surface/surface";
import { type PictureRequest, pictureOf } from "#workers/space/complete-picture";
import { type Completed, lookOf, type Surface, sameView, type Wanted } from "./surface";

/** While things move, a picture with so many times fewer pixels a side. */
const COARSE = 4;

/** Fills the canvas with pictures that a worker carves: slower than a graphics card, and never blank. */
export class Plain implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly backend = "canvas";
  /** What is being made coarsely, and what is to be made next. */
  #making: Wanted | null = null;
  #next: Wanted | null = null;
  /** The last one that was completed or is being: a coarse picture must not come after it. */
  #completing: Wanted | null = null;
  readonly #end = new AbortController();

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
  }

  keeps(before: Wanted, after: Wanted): boolean {
    return (
      sameView(before, after) &&
      before.light === after.light &&
      before.palette === after.palette &&
      before.ground === after.ground
    );
  }

  draw(wanted: Wanted): { points: number } {
    // Throws where there is no such view, as the renderer does.
    wanted.sight.handle.uniforms(wanted.view, wanted.light, lookOf(wanted));
    if (this.#completing && this.keeps(this.#completing, wanted)) return { points: 0 };
    this.#completing = null;
    this.#next = wanted;
    if (!this.#making) void this.#make();
    return { points: 0 };
  }

  async #make(): Promise<void> {
    while (this.#next && !this.#end.signal.aborted) {
      const wanted = this.#next;
      this.#making = wanted;
      this.#next = null;
      try {
        const size = {
          width: Math.ceil(wanted.width / COARSE),
          height: Math.ceil(wanted.height / COARSE),
        };
        const image = await pictureOf({ ...request(wanted), ...size, factor: 1 }, this.#options());
        if (!this.#completing) this.#put(image, wanted);
      } catch {
        // The next one may come, and the complete one says what is wrong.
      }
    }
    this.#making = null;
  }

  async complete(
    wanted: Wanted,
    signal: AbortSignal,
    onShown: (completed: Completed) => void,
  ): Promise<void> {
    this.#completing = wanted;
    this.#next = null;
    try {
      for (const factor of wanted.factor === 2 ? ([1, 2] as const) : ([1] as const)) {
        const image = await pictureOf({ ...request(wanted), factor }, { signal, lane: 0 });
        if (signal.aborted) throw { code: "stopped", message: "Something else was asked for." };
        this.#put(image, wanted);
        onShown({ empty: image.data.every((value, i) => i % 4 !== 3 || value === 0) });
      }
    } catch (problem) {
      this.#completing = null;
      throw problem;
    }
  }

  #options(): { signal: AbortSignal; lane: 0 } {
    return { signal: this.#end.signal, lane: 0 };
  }

  #put(image: ImageData, { width, height }: Wanted): void {
    this.canvas.width = width;
    this.canvas.height = height;
    const context = this.canvas.getContext("2d");
    if (!context) return;
    if (image.width === width && image.height === height) {
      context.putImageData(image, 0, 0);
      return;
    }
    const small = document.createElement("canvas");
    small.width = image.width;
    small.height = image.height;
    small.getContext("2d")?.putImageData(image, 0, 0);
    context.drawImage(small, 0, 0, width, height);
  }

  objectAt(): null {
    // Pictures come painted: nobody has kept what is where.
    return null;
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    const image = this.canvas.getContext("2d")?.getImageData(0, 0, width, height);
    if (!image) throw new Error("There is no picture yet.");
    return { width, height, data: image.data };
  }

  forceLoss(): void {
    // There is no device to lose.
  }

  free(): void {
    this.#end.abort();
  }
}

function request(wanted: Wanted): PictureRequest {
  const { sight, view, light } = wanted;
  return { ...lookOf(wanted), view, light, objects: sight.objects };
}
