import type { Renderer } from "./frond-webgl2.js";

export type { Renderer } from "./frond-webgl2.js";

export interface RendererOptions {
  /** Default `auto`: WebGPU, or WebGL2 where that is missing. */
  backend?: "auto" | "webgpu" | "webgl2";
  /** Called once if the device or the context is lost: the canvas is of no use any more then. */
  onLost?: (reason: string) => void;
}

/** A live picture on a canvas that has had no context yet. Rejects with a FrondError where there is no graphics card. */
export function createRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options?: RendererOptions,
): Promise<Renderer>;
