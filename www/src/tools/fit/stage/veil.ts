/** What a mask leaves out, as a picture that is laid over the photograph. */
import type { Masked } from "#workers/fit/trace-types";

/** How much of the photograph is covered where it is left out. */
const COVER = 0.72;

let last: { mask: Masked; colour: string; canvas: HTMLCanvasElement } | null = null;

/** One canvas, made again when the mask or the colour ("#rrggbb") has changed. */
export function veilOf(mask: Masked, colour: string): HTMLCanvasElement | null {
  if (last && last.mask === mask && last.colour === colour) return last.canvas;
  const { width, height } = mask;
  const canvas = last?.canvas ?? document.createElement("canvas");
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  if (!context || width === 0 || height === 0) return null;
  const image = context.createImageData(width, height);
  const [r, g, b] = [1, 3, 5].map((i) => Number.parseInt(colour.slice(i, i + 2), 16) || 0);
  const bytes = new Uint8Array([r ?? 0, g ?? 0, b ?? 0, Math.round(255 * COVER)]);
  const outside = new Uint32Array(bytes.buffer)[0] ?? 0;
  const words = new Uint32Array(image.data.buffer);
  for (let i = 0; i < words.length; i++) if (mask.mask[i] === 0) words[i] = outside;
  context.putImageData(image, 0, 0);
  last = { mask, colour, canvas };
  return canvas;
}

/** Lets go of it: it may be large. */
export function dropVeil(): void {
  last = null;
}
