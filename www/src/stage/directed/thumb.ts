/** Small pictures of graph-directed shapes. */
import type { DirectedIfs } from "#wasm/api";
import type { RenderStyle } from "#wasm/core";
import { directedTask } from "#workers/directed/client";
import { directedLook } from "./options";

/** CSS pixels. */
export interface PictureSize {
  width: number;
  height: number;
}

/** The whole shape, with a margin. */
export function directedPicture(
  { states }: DirectedIfs,
  size: PictureSize,
  style: RenderStyle,
  signal: AbortSignal,
): Promise<ImageBitmap> {
  const ratio = Math.min(2, globalThis.devicePixelRatio || 1);
  const options = {
    width: Math.round(size.width * ratio),
    height: Math.round(size.height * ratio),
    ...directedLook(style.colouring, style.palette),
  };
  return directedTask("picture", { system: { states }, options }, { signal });
}
