import { NIGHT, WHITE } from "#style/colours";
import type { FrameSize } from "./format/sink";

/** Of the shorter side of a frame. */
const TEXT_SIZE = 0.045;
const LEAST_TEXT = 9;
/** Behind words, whatever the picture. */
const SHADE = `${NIGHT}b3`;

/** The frame with words in its corner, on a ground of their own. The frame itself stays as it is. */
export function captioned(
  pixels: Uint8ClampedArray<ArrayBuffer>,
  { width, height }: FrameSize,
  words: string,
): Uint8ClampedArray<ArrayBuffer> {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) return pixels;
  context.putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
  const size = Math.max(LEAST_TEXT, Math.round(TEXT_SIZE * Math.min(width, height)));
  context.font = `${size}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  const pad = size / 2;
  const across = Math.min(width, context.measureText(words).width + 2 * pad);
  const top = height - 2 * size - pad;
  context.fillStyle = SHADE;
  context.beginPath();
  context.roundRect(pad, top, across, 2 * size, pad);
  context.fill();
  context.fillStyle = WHITE;
  context.fillText(words, 2 * pad, top + size, Math.max(1, width - 4 * pad));
  return context.getImageData(0, 0, width, height).data as Uint8ClampedArray<ArrayBuffer>;
}
