import type { Pixels } from "#stage/surface/surface";
import { media } from "#style/media";
import type { SpaceLook } from "#wasm/space";
import type { SpaceRenderer } from "#wasm/space-renderer";
import { objectAt, type Relief } from "#workers/space/picture";
import * as messages from "../../messages";
import { Detail, HANDHELD } from "./detail";
import { castsShadows, Still } from "./still";
import { type Completed, lookOf, type Surface, sameLight, sameView, type Wanted } from "./surface";

const handheld = media("(pointer: coarse) and (max-width: 53.6875em)");

/**
 * Clouds of points on the graphics card while something moves; the carved picture, lit there, when it rests. Over it
 * lies the one that the processor lights, where shadows are cast.
 */
export class Accelerated implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly backend: SpaceRenderer["backend"];
  readonly #renderer: SpaceRenderer;
  readonly #detail = new Detail(handheld.peek() ? HANDHELD : 0);
  #given: Wanted | null = null;
  /** Points in the clouds that the renderer has. */
  #clouds = 0;
  #size = "";
  /** Pixels carved for each one shown, in the picture that is shown; null while it is points. */
  #still: SpaceLook["factor"] | null = null;
  #relief: Relief | null = null;
  readonly #carved = new Still();
  /** What the processor lit, while it is shown. */
  readonly #lit = document.createElement("canvas");
  #freed = false;

  constructor(renderer: SpaceRenderer, canvas: HTMLCanvasElement) {
    this.backend = renderer.backend;
    this.canvas = canvas;
    this.#renderer = renderer;
    this.#lit.setAttribute("aria-hidden", "true");
  }

  keeps(before: Wanted, after: Wanted): boolean {
    return sameView(before, after) && (!castsShadows(after) || sameLight(before, after));
  }

  draw(wanted: Wanted, waited: number): { points: number } {
    const renderer = this.#renderer;
    if (!this.#given || !sameView(this.#given, wanted) || !sameLight(this.#given, wanted)) this.#lit.remove();
    if (!this.#given || !sameView(this.#given, wanted)) {
      this.#still = null;
      this.#detail.frame(waited);
    }
    const { points, shrink } = this.#detail.level;
    if (wanted.sight !== this.#given?.sight || (this.#clouds !== points && this.#still === null)) {
      renderer.setClouds(wanted.sight.handle.clouds(points));
      this.#clouds = points;
    }
    this.#light(wanted, this.#still === null ? shrink : 1, this.#still ?? wanted.factor);
    this.#given = wanted;
    return renderer.draw();
  }

  async complete(
    wanted: Wanted,
    signal: AbortSignal,
    onShown: (completed: Completed) => void,
  ): Promise<void> {
    // One pixel for each comes soon; what smooths it takes four times as long.
    for (const factor of wanted.factor === 2 ? ([1, 2] as const) : ([1] as const)) {
      const relief = await this.#carved.relief(wanted, factor, signal);
      const image = castsShadows(wanted) ? await this.#carved.lit(wanted, factor, relief, signal) : null;
      if (signal.aborted || this.#freed)
        throw { code: "stopped", message: messages.anotherPictureWasRequested };
      // The light may have changed meanwhile.
      this.#light(this.#given ?? wanted, 1, factor);
      if (!this.#renderer.setStill(relief.width, relief.height, relief.depth, relief.codes)) {
        // A graphics card that takes no picture as large as this shows the one that it has.
        if (factor === 2) return this.#light(this.#given ?? wanted, 1, 1);
        throw new Error(messages.graphicsCardCannotDraw);
      }
      this.#still = factor;
      this.#renderer.draw();
      if (image) this.#cover(image);
      this.#relief = relief;
      onShown({ empty: relief.empty });
    }
  }

  /** Shows a picture over that of the card. */
  #cover(image: ImageData): void {
    this.#lit.width = image.width;
    this.#lit.height = image.height;
    this.#lit.getContext("2d")?.putImageData(image, 0, 0);
    this.canvas.after(this.#lit);
  }

  /** Size, eye and light, as the renderer is to have them. */
  #light(wanted: Wanted, shrink: number, factor: SpaceLook["factor"]): void {
    const width = Math.ceil(wanted.width / shrink);
    const height = Math.ceil(wanted.height / shrink);
    if (this.#size !== `${width} ${height}`) {
      this.#size = `${width} ${height}`;
      this.canvas.width = width;
      this.canvas.height = height;
      this.#renderer.resize(width, height);
    }
    const look = { ...lookOf(wanted), width, height, factor };
    this.#renderer.setUniforms(wanted.sight.handle.uniforms(wanted.view, wanted.light, look));
  }

  objectAt(x: number, y: number): number | null {
    return this.#still === null || !this.#relief ? null : objectAt(this.#relief, x, y);
  }

  async pixels(): Promise<Pixels> {
    const { width, height } = this.canvas;
    const lit = this.#lit.isConnected ? this.#lit.getContext("2d") : null;
    if (lit) return { width, height, data: lit.getImageData(0, 0, width, height).data };
    const data = await this.#renderer.readPixels();
    return { width, height, data: new Uint8ClampedArray(data) };
  }

  forceLoss(): void {
    this.#renderer.forceLoss();
  }

  free(): void {
    this.#freed = true;
    this.#lit.remove();
    try {
      this.#renderer.free();
    } catch {
      // A device that is gone may refuse to be let go.
    }
  }
}
