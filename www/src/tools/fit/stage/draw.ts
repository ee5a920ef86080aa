/** Paints the stage of the fit, in device pixels. */
import type { View } from "#geometry/coordinates";
import { type Frame as CanvasFrame, fillPath, outlinePaths, place } from "#stage/curve/outline";
import type { Collage } from "#workers/fit/curve";
import type { Masked, Stroke } from "#workers/fit/trace-types";
import type { CopyPaths } from "../copies/copies";
import type { Frame } from "../work/source";

// What a mask leaves out, as a picture that is laid over the photograph.

/** How much of the photograph is covered where it is left out. */
const COVER = 0.72;

let last: { mask: Masked; colour: string; canvas: HTMLCanvasElement } | null = null;

/** One canvas, made again when the mask or the colour ("#rrggbb") has changed. */
function veilOf(mask: Masked, colour: string): HTMLCanvasElement | null {
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

export interface Colours {
  stage: string;
  ink: string;
  quiet: string;
  fit: string;
  bad: string;
  accent: string;
  /** Of arcs that are copied, again and again. */
  arcs: readonly string[];
}

/** All that is on the stage. Points are x0, y0, x1, y1, .. in the plane. */
export interface Sight {
  /** A picture with the pixels it has. */
  photo: { bitmap: ImageBitmap; width: number; height: number; faint: boolean } | null;
  mask: Masked | null;
  frame: Frame;
  outline: Float64Array | null;
  /** Whether the outline is filled: it is what is looked at. */
  filled: boolean;
  fit: Float64Array | null;
  /** Pieces of the paper's fit in its place. */
  collage: Collage | null;
  /** Which edges copy which arcs. */
  copies: CopyPaths | null;
  marks: Float64Array | null;
  strokes: readonly Stroke[];
  cursor: { x: number; y: number; radius: number; what: "keep" | "remove" } | null;
}

const SOFT = 0.16;

export function paint(
  context: CanvasRenderingContext2D,
  size: { width: number; height: number; ratio: number },
  view: View,
  sight: Sight,
  colours: Colours,
): void {
  const { width, height, ratio } = size;
  const on: CanvasFrame = { width, height, view: { ...view, scale: view.scale * ratio } };
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = 1;
  context.clearRect(0, 0, width, height);
  context.lineJoin = "round";
  context.lineCap = "round";
  if (sight.photo) paintPhoto(context, on, sight, colours);
  if (sight.outline) {
    const colour = sight.photo && !sight.photo.faint ? colours.accent : colours.quiet;
    const look = {
      fill: sight.filled ? colour : null,
      width: sight.filled ? 1.5 : 1.25,
      halo: sight.photo !== null,
    };
    ring(context, on, ratio, sight.outline, colour, look, colours);
  }
  if (sight.fit) {
    const look = { fill: colours.fit, width: 1.75, halo: sight.photo !== null };
    ring(context, on, ratio, sight.fit, colours.fit, look, colours);
  }
  if (sight.collage) pieces(context, on, ratio, sight.collage, colours);
  if (sight.copies) paintCopies(context, on, ratio, sight.copies, colours);
  if (sight.marks) dots(context, on, ratio, sight.marks, colours);
  paintBrush(context, on, ratio, sight, colours);
}

interface Look {
  fill: string | null;
  width: number;
  halo: boolean;
}

function ring(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  ratio: number,
  points: Float64Array,
  colour: string,
  look: Look,
  colours: Colours,
): void {
  const placed = place(points, on);
  if (look.fill) {
    const area = new Path2D();
    fillPath(area, placed);
    context.globalAlpha = SOFT;
    context.fillStyle = look.fill;
    context.fill(area, "evenodd");
    context.globalAlpha = 1;
  }
  for (const path of outlinePaths(placed, () => new Path2D()).values()) {
    if (look.halo) {
      context.globalAlpha = 0.7;
      context.strokeStyle = colours.stage;
      context.lineWidth = (look.width + 2) * ratio;
      context.stroke(path);
      context.globalAlpha = 1;
    }
    context.strokeStyle = colour;
    context.lineWidth = look.width * ratio;
    context.stroke(path);
  }
}

/** Pieces that need not meet, and their gaps: a line with a ring at each end, so that colour is not all that tells. */
function pieces(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  ratio: number,
  { points, starts, gaps, widest }: Collage,
  colours: Colours,
): void {
  const placed = place(points, on).points;
  const path = new Path2D();
  for (let k = 0; k + 1 < starts.length; k++) {
    for (let i = starts[k] ?? 0; i < (starts[k + 1] ?? 0); i++) {
      const [x, y] = [placed[2 * i] ?? 0, placed[2 * i + 1] ?? 0];
      if (i === starts[k]) path.moveTo(x, y);
      else path.lineTo(x, y);
    }
  }
  context.globalAlpha = SOFT;
  context.fillStyle = colours.fit;
  const area = new Path2D();
  fillPath(area, place(points, on));
  context.fill(area, "evenodd");
  context.globalAlpha = 1;
  context.strokeStyle = colours.fit;
  context.lineWidth = 1.75 * ratio;
  context.stroke(path);
  if (!(widest > 1e-6)) return;
  const ends = place(gaps, on).points;
  context.strokeStyle = colours.bad;
  context.lineWidth = 2 * ratio;
  for (let i = 0; i + 3 < ends.length; i += 4) {
    const [x0, y0, x1, y1] = [ends[i] ?? 0, ends[i + 1] ?? 0, ends[i + 2] ?? 0, ends[i + 3] ?? 0];
    if (Math.hypot(x1 - x0, y1 - y0) < 1.5 * ratio) continue;
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
    const middle = [(x0 + x1) / 2, (y0 + y1) / 2] as const;
    context.beginPath();
    context.setLineDash([3 * ratio, 3 * ratio]);
    context.arc(...middle, Math.hypot(x1 - x0, y1 - y0) / 2 + 6 * ratio, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
  }
}

/** Copies in the colour of their arc; the one that is looked at is thick, its arc dashed, whatever their colours. */
function paintCopies(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  ratio: number,
  { edges, groups, chosen, arc }: CopyPaths,
  colours: Colours,
): void {
  const line = (points: Float64Array, colour: string, width: number) => {
    const placed = place(points, on).points;
    context.beginPath();
    for (let i = 0; i + 1 < placed.length; i += 2) {
      if (i === 0) context.moveTo(placed[0] ?? 0, placed[1] ?? 0);
      else context.lineTo(placed[i] ?? 0, placed[i + 1] ?? 0);
    }
    context.strokeStyle = colour;
    context.lineWidth = width * ratio;
    context.stroke();
  };
  const colourOf = (index: number) => colours.arcs[(groups[index] ?? 0) % colours.arcs.length] ?? colours.ink;
  for (const [index, path] of edges.entries()) line(path, colourOf(index), 2.5);
  line(arc, colours.stage, 6);
  context.setLineDash([7 * ratio, 6 * ratio]);
  line(arc, colours.ink, 3);
  context.setLineDash([]);
  const one = edges[chosen];
  if (!one) return;
  line(one, colours.stage, 9);
  line(one, colours.ink, 6);
  line(one, colourOf(chosen), 3);
}

function dots(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  ratio: number,
  marks: Float64Array,
  colours: Colours,
): void {
  const { points } = place(marks, on);
  const path = new Path2D();
  const radius = 2.25 * ratio;
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [points[i] ?? 0, points[i + 1] ?? 0];
    if (x < -9 || y < -9 || x > on.width + 9 || y > on.height + 9) continue;
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
  context.strokeStyle = colours.stage;
  context.lineWidth = 2 * ratio;
  context.stroke(path);
  context.fillStyle = colours.ink;
  context.fill(path);
}

/** Where a pixel of the picture lies on the canvas, and how many pixels of it there are a pixel of the picture. */
function pixels(on: CanvasFrame, { frame, photo, mask }: Sight): (x: number, y: number) => [number, number] {
  const tall = photo?.height ?? mask?.height ?? 0;
  return (x, y) => {
    const wx = (x - frame.x) * frame.scale;
    const wy = (tall - y - frame.y) * frame.scale;
    return [
      on.width / 2 + (wx - on.view.x) * on.view.scale,
      on.height / 2 - (wy - on.view.y) * on.view.scale,
    ];
  };
}

function paintPhoto(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  sight: Sight,
  colours: Colours,
): void {
  const { photo, mask, frame } = sight;
  // One that was closed has no size.
  if (!photo || photo.bitmap.width === 0) return;
  const [left, top] = pixels(on, sight)(0, 0);
  const across = photo.width * frame.scale * on.view.scale;
  const up = photo.height * frame.scale * on.view.scale;
  context.imageSmoothingEnabled = across < 3 * photo.width;
  context.imageSmoothingQuality = "high";
  context.globalAlpha = photo.faint ? 0.45 : 1;
  context.drawImage(photo.bitmap, left, top, across, up);
  context.globalAlpha = 1;
  const veil = mask && !photo.faint ? veilOf(mask, colours.stage) : null;
  if (veil) context.drawImage(veil, left, top, across, up);
}

function paintBrush(
  context: CanvasRenderingContext2D,
  on: CanvasFrame,
  ratio: number,
  sight: Sight,
  colours: Colours,
): void {
  const at = pixels(on, sight);
  const scale = sight.frame.scale * on.view.scale;
  for (const { points, radius, what } of sight.strokes) {
    context.globalAlpha = 0.6;
    context.strokeStyle = what === "keep" ? colours.fit : colours.bad;
    context.lineWidth = 2 * radius * scale;
    // What is not leaf is broken: the colour is not all that tells.
    context.setLineDash(what === "keep" ? [] : [1, 4 * radius * scale]);
    context.beginPath();
    for (let i = 0; i + 1 < points.length; i += 2) {
      const [x, y] = at(points[i] ?? 0, points[i + 1] ?? 0);
      if (i === 0) context.moveTo(x, y);
      context.lineTo(x, y);
    }
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }
  const { cursor } = sight;
  if (!cursor) return;
  const [x, y] = at(cursor.x, cursor.y);
  const radius = Math.max(2 * ratio, cursor.radius * scale);
  // Light on dark and dark on light: it is seen on any picture. A plus keeps, a minus takes away.
  for (const [colour, wide] of [
    [colours.stage, 4],
    [colours.ink, 1.75],
  ] as const) {
    context.strokeStyle = colour;
    context.lineWidth = wide * ratio;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    const arm = 5 * ratio;
    context.moveTo(x - arm, y);
    context.lineTo(x + arm, y);
    if (cursor.what === "keep") {
      context.moveTo(x, y - arm);
      context.lineTo(x, y + arm);
    }
    context.stroke();
  }
}
