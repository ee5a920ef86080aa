import type { Photograph } from "#document/deform/photograph";
import type { View } from "#geometry/coordinates";
import type { Bend, MapRow } from "#wasm/api";
import type { RenderStyle } from "#wasm/core";
import type { Renderer } from "#wasm/renderer";
import type { Drawn, Pixels, Surface } from "./surface";

/** The renderer of the Rust side, in the page's units. */
export class Accelerated implements Surface {
  readonly canvas: HTMLCanvasElement;
  readonly #renderer: Renderer;

  constructor(renderer: Renderer, canvas: HTMLCanvasElement) {
    this.#renderer = renderer;
    this.canvas = canvas;
  }

  setMaps(maps: MapRow[], weights: number[] | undefined): void {
    this.#renderer.setIfs(new Float64Array(maps.flat()), weights && new Float64Array(weights));
  }

  setPicture(picture: Photograph | null): void {
    this.#renderer.setPicture(picture?.pixels ?? null, picture?.width ?? 0, picture?.height ?? 0);
  }

  setBend(bend: Bend | null): void {
    this.#renderer.setBend(bend);
  }

  setView(view: View, ratio: number): void {
    this.#renderer.setView(view.x, view.y, view.scale * ratio);
  }

  setStyle(style: RenderStyle): void {
    this.#renderer.setStyle(style);
  }

  resize(width: number, height: number): void {
    this.canvas.width = width;
    this.canvas.height = height;
    this.#renderer.resize(width, height);
  }

  draw(budget: number): Drawn {
    return this.#renderer.draw(Math.round(budget));
  }

  async pixels(): Promise<Pixels> {
    const data = await this.#renderer.readPixels();
    return { width: this.canvas.width, height: this.canvas.height, data: new Uint8ClampedArray(data) };
  }

  free(): void {
    this.#renderer.free();
  }
}
