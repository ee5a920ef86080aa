import { NIGHT, WHITE } from "#style/colours";
import type { FrameSize } from "./format/sink";

/** Of the shorter side of a frame. */
const TEXT_SIZE = 0.045;
const LEAST_TEXT = 9;
/** Behind words, whatever the picture. */
const SHADE = `${NIGHT}b3`;

/** Words in the corner, on a ground of their own. */
export function drawCaption(
  context: OffscreenCanvasRenderingContext2D,
  { width, height }: FrameSize,
  words: string,
): void {
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
}
