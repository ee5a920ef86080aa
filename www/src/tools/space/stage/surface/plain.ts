import type { PainterBackend } from "#stage/surface/painter";
import type { Pixels } from "#stage/surface/surface";
import { pictureInBands } from "#workers/space/bands";
import { objectAt, type PictureRequest, type Relief } from "#workers/space/picture";
import * as messages from "../../messages";
import { Pace } from "./pace";
import { Still } from "./still";
import { type Completed, lookOf, type Surface, sameView, type Wanted } from "./surface";

/**
 * Fills the canvas with pictures that workers carve: with fewer pixels while something moves, so that they come in
 * time. Slower than a graphics card, and never blank.
 */
export class Plain implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly backend: PainterBackend = "canvas";
  readonly #pace = new Pace();
  /** Whether a picture of the movement is being made, and what the next is to show: none waits for another. */
  #making = false;
  #next: Wanted | null = null;
  /** The last one that was completed or is being: a coarse picture must not come after it. */
  #completing: Wanted | null = null;
  /** Of the picture that is shown; null while things move. */
  #seen: Relief | null = null;
  readonly #still = new Still();
  readonly #small = document.createElement("canvas");
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
    this.#seen = null;
    this.#next = wanted;
    if (!this.#making) void this.#make();
    return { points: 0 };
  }

  async #make(): Promise<void> {
    this.#making = true;
    while (this.#next && !this.#end.signal.aborted) {
      const wanted = this.#next;
      this.#next = null;
      try {
        await this.#moving(wanted);
      } catch {
        // The next one may come, and the complete one says what is wrong.
      }
    }
    this.#making = false;
  }

  async #moving(wanted: Wanted): Promise<void> {
    this.#pace.stage(wanted.width * wanted.height);
    const { shrink } = this.#pace;
    const size = { width: Math.ceil(wanted.width / shrink), height: Math.ceil(wanted.height / shrink) };
    const began = performance.now();
    // Hollows are as wide as in the picture that it comes to rest in.
    const options = { reach: 1 / (shrink * wanted.factor), atRest: false, signal: this.#end.signal };
    // Shadows are cast at rest: to look from the lamp as well would take as long again.
    const light = { ...wanted.light, shadows: 0, occlusion: 0 };
    const { image } = await pictureInBands({ ...request(wanted), light, ...size, factor: 1 }, options);
    this.#pace.frame(performance.now() - began, shrink);
    if (!this.#completing) this.#put(image, wanted);
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
        const relief = await this.#still.relief(wanted, factor, signal);
        const image = await this.#still.lit(wanted, factor, relief, signal);
        if (signal.aborted) throw { code: "stopped", message: messages.anotherPictureWasRequested };
        this.#put(image, wanted);
        this.#seen = relief;
        onShown({ empty: relief.empty });
      }
    } catch (problem) {
      this.#completing = null;
      throw problem;
    }
  }

  #put(image: ImageData, { width, height }: Wanted): void {
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    const context = this.canvas.getContext("2d");
    if (!context) return;
    if (image.width === width && image.height === height) {
      context.putImageData(image, 0, 0);
      return;
    }
    this.#small.width = image.width;
    this.#small.height = image.height;
    this.#small.getContext("2d")?.putImageData(image, 0, 0);
    context.clearRect(0, 0, width, height);
    context.imageSmoothingQuality = "high";
    context.drawImage(this.#small, 0, 0, width, height);
  }

  objectAt(x: number, y: number): number | null {
    return this.#seen ? objectAt(this.#seen, x, y) : null;
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    const image = this.canvas.getContext("2d")?.getImageData(0, 0, width, height);
    if (!image) throw new Error(messages.thereNoPictureYet);
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
