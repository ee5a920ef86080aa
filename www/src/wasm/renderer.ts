import { createRenderer as create, type Renderer, type RendererOptions } from "../../pkg/renderer.js";
import { settled } from "./webgpu";

export type { Renderer, RendererOptions };
export type Backend = Renderer["backend"];

/** Loads the renderer for the graphics interface that there is: a module of its own, after the first picture. */
export async function createRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
): Promise<Renderer> {
  return create(canvas, await settled(options));
}
