import { createRenderer as create } from "../../pkg/renderer.js";
import type { Backend, Renderer } from "./core";
import { settled } from "./webgpu";

export interface RendererOptions {
  backend?: "auto" | Backend;
  onLost?: (reason: string) => void;
}

const open = create as unknown as (
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
) => Promise<Renderer>;

/** Loads the renderer for the graphics interface that there is: a module of its own, after the first picture. */
export async function createRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
): Promise<Renderer> {
  return open(canvas, await settled(options));
}
