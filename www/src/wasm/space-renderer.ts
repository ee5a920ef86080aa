import {
  createSpaceRenderer as create,
  type RendererOptions,
  type SpaceRenderer,
} from "../../pkg/renderer.js";
import { settled } from "./webgpu";

export type { SpaceRenderer };

/** Loads the renderer for the graphics interface that there is. */
export async function createSpaceRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
): Promise<SpaceRenderer> {
  return create(canvas, await settled(options));
}
