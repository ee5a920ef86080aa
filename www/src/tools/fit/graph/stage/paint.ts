/** The graph and what lies under and over it, on a canvas. */
import type { Graph } from "#wasm/api";
import * as messages from "../messages";
import { rangeOf } from "../model/model";
import { type Frame, leftOf, startIn, ticks, tickText, topOf } from "./frame";

export interface Paints {
  palette: readonly string[];
  ink: string;
  quiet: string;
  line: string;
  ground: string;
  accent: string;
}

export interface Copy {
  /** Feature points of the part that is copied, and where its map takes them. */
  from: Float64Array;
  to: Float64Array;
}

export interface Scenery {
  pieces: Graph["pieces"];
  polyline: Float64Array;
  /** Whether the graph is only in the way: then it is drawn faintly. */
  faint: boolean;
  series: Float64Array | null;
  copy: Copy | null;
  /** Where the graph is farthest from what is measured. */
  worst: number | null;
  chosenPiece: number;
}

const FONT = "12px system-ui, sans-serif";
/** How far below the plot the band of pieces lies, and how high it is. */
export const BAND = { below: 26, height: 18 };

export function paint(
  context: CanvasRenderingContext2D,
  frame: Frame,
  scenery: Scenery,
  paints: Paints,
): void {
  axes(context, frame, paints);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top - 8, frame.width, frame.height + 16);
  context.clip();
  if (scenery.series) measured(context, frame, scenery.series, paints);
  if (scenery.worst !== null) {
    context.strokeStyle = paints.ink;
    context.lineWidth = 1;
    context.setLineDash([3, 3]);
    const left = leftOf(frame, scenery.worst);
    stroke(context, [
      [left, frame.top],
      [left, frame.top + frame.height],
    ]);
    context.setLineDash([]);
    context.font = FONT;
    context.fillStyle = paints.quiet;
    context.textBaseline = "bottom";
    const room = left < frame.left + frame.width - 110;
    context.textAlign = room ? "left" : "right";
    context.fillText(messages.largestErrorHere, left + (room ? 4 : -4), frame.top + frame.height - 2);
  }
  pieces(context, frame, scenery, paints);
  if (scenery.copy) copy(context, frame, scenery.copy, paints);
  context.restore();
  band(context, frame, scenery, paints);
}

function stroke(context: CanvasRenderingContext2D, points: readonly (readonly [number, number])[]): void {
  context.beginPath();
  for (const [i, [left, top]] of points.entries()) {
    if (i === 0) context.moveTo(left, top);
    else context.lineTo(left, top);
  }
  context.stroke();
}

function axes(context: CanvasRenderingContext2D, frame: Frame, paints: Paints): void {
  const { left, top, width, height } = frame;
  context.font = FONT;
  context.lineWidth = 1;
  context.fillStyle = paints.quiet;
  const across = ticks(frame.t, Math.max(2, Math.floor(width / 90)));
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const t of across.values) {
    const at = Math.round(leftOf(frame, t)) + 0.5;
    context.strokeStyle = paints.line;
    stroke(context, [
      [at, top],
      [at, top + height + 4],
    ]);
    context.fillText(tickText(t, across), at, top + height + 8);
  }
  const up = ticks(frame.x, Math.max(2, Math.floor(height / 56)));
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const x of up.values) {
    const at = Math.round(topOf(frame, x)) + 0.5;
    context.strokeStyle = paints.line;
    stroke(context, [
      [left - 4, at],
      [left + width, at],
    ]);
    context.fillText(tickText(x, up), left - 8, at);
  }
  context.textAlign = "left";
  context.font = `italic ${FONT}`;
  context.fillText("x", left + 5, top + 2);
  context.textAlign = "right";
  context.fillText("t", left + width - 3, top + height - 8);
}

/** Points where they can be told apart, else all heights that each column of pixels has. */
function measured(
  context: CanvasRenderingContext2D,
  frame: Frame,
  points: Float64Array,
  paints: Paints,
): void {
  const from = Math.max(0, startIn(points, frame.t[0]) - 2);
  const until = Math.min(points.length, startIn(points, frame.t[1]) + 2);
  const count = (until - from) / 2;
  context.strokeStyle = paints.quiet;
  context.fillStyle = paints.quiet;
  context.globalAlpha = 0.75;
  context.lineWidth = 1;
  context.beginPath();
  if (count <= 2 * frame.width) {
    for (let i = from; i < until; i += 2) {
      const at = [leftOf(frame, points[i] ?? 0), topOf(frame, points[i + 1] ?? 0)] as const;
      if (i === from) context.moveTo(...at);
      else context.lineTo(...at);
    }
    context.stroke();
    if (count <= frame.width / 5) {
      for (let i = from; i < until; i += 2) {
        context.beginPath();
        context.arc(leftOf(frame, points[i] ?? 0), topOf(frame, points[i + 1] ?? 0), 1.75, 0, 7);
        context.fill();
      }
    }
  } else {
    let column = Number.NaN;
    let [low, high, last] = [0, 0, 0];
    const flush = () => {
      if (!Number.isNaN(column)) context.fillRect(column, high, 1, Math.max(1, low - high));
    };
    for (let i = from; i < until; i += 2) {
      const at = Math.round(leftOf(frame, points[i] ?? 0));
      const top = topOf(frame, points[i + 1] ?? 0);
      if (at !== column) {
        flush();
        // From where the last column ended, so that the line has no holes.
        const begin = Number.isNaN(column) ? top : last;
        [column, low, high] = [at, begin, begin];
      }
      low = Math.max(low, top);
      high = Math.min(high, top);
      last = top;
    }
    flush();
  }
  context.globalAlpha = 1;
}

function pieces(context: CanvasRenderingContext2D, frame: Frame, scenery: Scenery, paints: Paints): void {
  const { polyline } = scenery;
  context.lineJoin = "round";
  context.globalAlpha = scenery.faint ? 0.4 : 1;
  for (const [index, piece] of scenery.pieces.entries()) {
    const [from, to] = rangeOf(piece);
    if (to < frame.t[0] || from > frame.t[1]) continue;
    const near = 1e-9 * (Math.abs(from) + Math.abs(to));
    context.strokeStyle = paints.palette[index % paints.palette.length] ?? paints.ink;
    context.lineWidth = index === scenery.chosenPiece ? 2.5 : 1.75;
    context.beginPath();
    let drawn = false;
    for (let i = startIn(polyline, from - near); i + 1 < polyline.length; i += 2) {
      const t = polyline[i] ?? 0;
      if (t > to + near) break;
      const at = [leftOf(frame, t), topOf(frame, polyline[i + 1] ?? 0)] as const;
      if (drawn) context.lineTo(...at);
      else context.moveTo(...at);
      drawn = true;
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** Fig 5, middle: feature points, and those of the copied part where the map takes them. */
function copy(context: CanvasRenderingContext2D, frame: Frame, { from, to }: Copy, paints: Paints): void {
  context.fillStyle = paints.ink;
  for (let i = 0; i + 1 < from.length; i += 2) {
    context.beginPath();
    context.arc(leftOf(frame, from[i] ?? 0), topOf(frame, from[i + 1] ?? 0), 1.75, 0, 7);
    context.fill();
  }
  context.strokeStyle = paints.accent;
  context.lineWidth = 1.75;
  for (let i = 0; i + 1 < to.length; i += 2) {
    context.beginPath();
    context.arc(leftOf(frame, to[i] ?? 0), topOf(frame, to[i + 1] ?? 0), 4, 0, 7);
    context.stroke();
  }
  const bar = (points: Float64Array, top: number, colour: string, words: string) => {
    const ends = [points[0] ?? 0, points[points.length - 2] ?? 0].map((t) => leftOf(frame, t));
    const [left, right] = [Math.min(...ends), Math.max(...ends)];
    context.strokeStyle = colour;
    context.lineWidth = 2;
    stroke(context, [
      [left, top + 5],
      [left, top],
      [right, top],
      [right, top + 5],
    ]);
    context.font = FONT;
    context.textBaseline = "top";
    context.textAlign = "center";
    context.lineWidth = 4;
    context.strokeStyle = paints.ground;
    const middle = Math.min(frame.left + frame.width - 40, Math.max(frame.left + 40, (left + right) / 2));
    context.strokeText(words, middle, top + 4);
    context.fillStyle = colour;
    context.fillText(words, middle, top + 4);
  };
  bar(from, frame.top - 2, paints.ink, "copied");
  bar(to, frame.top + 18, paints.accent, "copy");
}

/** What each piece fills, with its number. */
function band(context: CanvasRenderingContext2D, frame: Frame, scenery: Scenery, paints: Paints): void {
  const top = frame.top + frame.height + BAND.below;
  context.save();
  context.beginPath();
  context.rect(frame.left, top - 2, frame.width, BAND.height + 4);
  context.clip();
  context.font = `600 ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [index, piece] of scenery.pieces.entries()) {
    const [from, to] = rangeOf(piece).map((t) => leftOf(frame, t)) as [number, number];
    if (to < frame.left || from > frame.left + frame.width) continue;
    const colour = paints.palette[index % paints.palette.length] ?? paints.ink;
    const chosen = index === scenery.chosenPiece;
    context.fillStyle = colour;
    context.globalAlpha = chosen ? 0.35 : 0.16;
    context.fillRect(from + 1, top, Math.max(1, to - from - 2), BAND.height);
    context.globalAlpha = 1;
    context.fillRect(from + 1, top + BAND.height - 3, Math.max(1, to - from - 2), 3);
    const [left, right] = [Math.max(from, frame.left), Math.min(to, frame.left + frame.width)];
    const text = piece.map[0] < 0 ? `${index + 1} ↔` : String(index + 1);
    if (right - left > 8 + 8 * text.length) {
      context.fillStyle = paints.ink;
      context.fillText(text, (left + right) / 2, top + BAND.height / 2 - 1);
    }
  }
  context.restore();
}
