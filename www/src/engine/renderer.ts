import { createRenderer as create } from "../../pkg/renderer.js";
import type { Backend, Renderer } from "./wasm";

export interface RendererOptions {
  backend?: "auto" | Backend;
  onLost?: (reason: string) => void;
}

/** Loads the renderer for the graphics interface that there is: a module of its own, after the first picture. */
export const createRenderer = create as unknown as (
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
) => Promise<Renderer>;
