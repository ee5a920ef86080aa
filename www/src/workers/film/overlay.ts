/** What lies over frames: words in a corner, and a small map with the way and the moment in another. */
import { INK, PAPER, WHITE } from "#style/colours";
import { drawCaption } from "./caption";
import type { FrameSize } from "./format/sink";
import type { Place } from "./subject";

/** A small map, as the worker has it. */
export interface InsetMap {
  /** Pixels along a side. */
  size: number;
  /** RGBA. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
  /** The way on it. */
  way: readonly Place[];
}

export interface Over {
  words?: string;
  inset?: { map: InsetMap; at: Place };
}

/** A side of the small map, as a part of the shorter side of a frame; so far from its corner. */
const SIDE = 0.3;
const FREE = 0.03;
/** Widths of the way and of the mark, as parts of the small map. */
const WAY = 0.018;
const MARK = 0.036;

/** The frame with all that lies over it. The frame itself stays as it is. */
export function overlaid(
  pixels: Uint8ClampedArray<ArrayBuffer>,
  size: FrameSize,
  { words, inset }: Over,
): Uint8ClampedArray<ArrayBuffer> {
  const { width, height } = size;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) return pixels;
  context.putImageData(new ImageData(new Uint8ClampedArray(pixels), width, height), 0, 0);
  if (inset) drawInset(context, size, inset.map, inset.at);
  if (words) drawCaption(context, size, words);
  return context.getImageData(0, 0, width, height).data as Uint8ClampedArray<ArrayBuffer>;
}

function drawInset(
  context: OffscreenCanvasRenderingContext2D,
  { width, height }: FrameSize,
  { size, pixels, way }: InsetMap,
  at: Place,
): void {
  const shorter = Math.min(width, height);
  const side = Math.max(1, Math.round(SIDE * shorter));
  const free = Math.round(FREE * shorter);
  const [left, top] = [width - side - free, free];
  const square = new OffscreenCanvas(size, size);
  square.getContext("2d")?.putImageData(new ImageData(pixels, size, size), 0, 0);
  const placed = ([x, y]: Place): [number, number] => [left + x * side, top + y * side];
  context.save();
  context.beginPath();
  context.rect(left, top, side, side);
  context.clip();
  context.fillStyle = PAPER;
  context.fillRect(left, top, side, side);
  context.imageSmoothingQuality = "high";
  context.drawImage(square, left, top, side, side);
  context.lineJoin = "round";
  context.lineCap = "round";
  context.beginPath();
  for (const place of way) context.lineTo(...placed(place));
  // Light within dark: seen on any colour.
  for (const [colour, part] of [
    [INK, 2 * WAY],
    [WHITE, WAY],
  ] as const) {
    context.strokeStyle = colour;
    context.lineWidth = Math.max(1, part * side);
    context.stroke();
  }
  for (const [colour, part] of [
    [WHITE, MARK],
    [INK, MARK - WAY],
  ] as const) {
    context.fillStyle = colour;
    context.beginPath();
    context.arc(...placed(at), Math.max(1, part * side), 0, 2 * Math.PI);
    context.fill();
  }
  context.restore();
  context.strokeStyle = INK;
  context.lineWidth = Math.max(1, 0.008 * side);
  context.strokeRect(left, top, side, side);
}
