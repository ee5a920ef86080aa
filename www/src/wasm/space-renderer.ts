import { createSpaceRenderer as create } from "../../pkg/renderer.js";
import type { Backend } from "./core";
import type { RendererOptions } from "./renderer";
import type { CloudBytes, UniformBytes } from "./space";
import { settled } from "./webgpu";

/**
 * What draws space on the graphics card: clouds of points, or, once it is set, the complete picture that was carved.
 * Other clouds, another eye and another size drop the complete picture.
 */
export interface SpaceRenderer {
  readonly backend: Backend;
  readonly description: string;
  /** Device pixels. */
  resize(width: number, height: number): void;
  setClouds(clouds: CloudBytes[]): void;
  setUniforms(uniforms: UniformBytes): void;
  /** As `SpaceCarveHandle` has it; `width` and `height` are what was carved. False where the uniforms say another size. */
  setStill(width: number, height: number, depth: Float32Array, codes: Uint32Array): boolean;
  draw(): { complete: boolean; points: number };
  /** RGBA, row 0 on top, of what was drawn last. */
  readPixels(): Promise<Uint8Array>;
  forceLoss(): void;
  free(): void;
}

const open = create as unknown as (
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
) => Promise<SpaceRenderer>;

/** Loads the renderer for the graphics interface that there is. */
export async function createSpaceRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options: RendererOptions,
): Promise<SpaceRenderer> {
  return open(canvas, await settled(options));
}
