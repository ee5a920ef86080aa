import type { Pixels } from "#stage/surface/surface";
import { media } from "#style/media";
import type { SpaceLook } from "#wasm/space";
import type { SpaceRenderer } from "#wasm/space-renderer";
import { reliefInBands } from "#workers/space/bands";
import { objectAt, type Relief } from "#workers/space/picture";
import { Detail, HANDHELD } from "./detail";
import { type Completed, lookOf, type Surface, sameView, type Wanted } from "./surface";

const handheld = media("(pointer: coarse) and (max-width: 53.6875em)");

/** Clouds of points on the graphics card while something moves; the carved picture, lit there, when it rests. */
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
  #freed = false;

  constructor(renderer: SpaceRenderer, canvas: HTMLCanvasElement) {
    this.backend = renderer.backend;
    this.canvas = canvas;
    this.#renderer = renderer;
  }

  keeps(before: Wanted, after: Wanted): boolean {
    return sameView(before, after);
  }

  draw(wanted: Wanted, waited: number): { points: number } {
    const renderer = this.#renderer;
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
    const { sight, view } = wanted;
    // One pixel for each comes soon; what smooths it takes four times as long.
    for (const factor of wanted.factor === 2 ? ([1, 2] as const) : ([1] as const)) {
      const size = { width: wanted.width * factor, height: wanted.height * factor };
      const args = { objects: sight.objects, view, ...size };
      const relief = await reliefInBands(args, { signal });
      if (signal.aborted || this.#freed) throw { code: "stopped", message: "Something else was asked for." };
      // The light may have changed meanwhile.
      this.#light(this.#given ?? wanted, 1, factor);
      if (!this.#renderer.setStill(relief.width, relief.height, relief.depth, relief.codes)) {
        // A graphics card that takes no picture as large as this shows the one that it has.
        if (factor === 2) return this.#light(this.#given ?? wanted, 1, 1);
        throw new Error("The graphics card takes no picture of this size. Make the window smaller.");
      }
      this.#still = factor;
      this.#renderer.draw();
      this.#relief = relief;
      onShown({ empty: relief.empty });
    }
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
    const data = await this.#renderer.readPixels();
    return { width, height, data: new Uint8ClampedArray(data) };
  }

  forceLoss(): void {
    this.#renderer.forceLoss();
  }

  free(): void {
    this.#freed = true;
    try {
      this.#renderer.free();
    } catch {
      // A device that is gone may refuse to be let go.
    }
  }
}
