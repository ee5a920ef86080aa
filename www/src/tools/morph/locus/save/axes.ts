import { fixed } from "#format/numbers";
import { INK, WHITE } from "#style/colours";
import type { Bounds } from "#wasm/api";
import { ticksOf } from "../view/geometry";

/** Room for numbers and names, in pixels. */
export const MARGIN = { left: 170, right: 40, top: 40, bottom: 140 };

const TICK = 14;
const FONT = "36px system-ui, sans-serif";

/** What of a canvas is used. */
type Pen = Pick<
  CanvasRenderingContext2D,
  | "fillRect"
  | "strokeRect"
  | "fillText"
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "stroke"
  | "fillStyle"
  | "strokeStyle"
  | "lineWidth"
  | "font"
  | "textAlign"
  | "textBaseline"
>;

/** A frame around a square picture, with numbers and names, on white: for papers. */
export function drawAxes(
  pen: Pen,
  size: number,
  { u0, u1, v0, v1 }: Bounds,
  names: { across: string; up: string },
  drawSquare: () => void,
): void {
  const { left, top } = MARGIN;
  const bottom = top + size;
  pen.fillStyle = WHITE;
  pen.fillRect(0, 0, size + left + MARGIN.right, size + top + MARGIN.bottom);
  drawSquare();
  pen.strokeStyle = INK;
  pen.fillStyle = INK;
  pen.lineWidth = 3;
  pen.font = FONT;
  pen.strokeRect(left, top, size, size);
  const tick = (x: number, y: number, dx: number, dy: number) => {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + dx, y + dy);
    pen.stroke();
  };
  pen.textAlign = "center";
  pen.textBaseline = "top";
  const across = ticksOf(u0, u1);
  for (const value of across.at) {
    const x = left + (size * (value - u0)) / (u1 - u0);
    tick(x, bottom, 0, TICK);
    pen.fillText(fixed(value, across.digits), x, bottom + TICK + 8);
  }
  pen.fillText(names.across, left + size / 2, bottom + 78);
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  const up = ticksOf(v0, v1);
  for (const value of up.at) {
    const y = bottom - (size * (value - v0)) / (v1 - v0);
    tick(left, y, -TICK, 0);
    pen.fillText(fixed(value, up.digits), left - TICK - 8, y);
  }
  pen.textAlign = "left";
  pen.fillText(names.up, 14, top + size / 2);
}
