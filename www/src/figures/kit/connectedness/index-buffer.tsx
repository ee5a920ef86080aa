import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { pictured, usePixels } from "../picture/canvas";
import { useValue } from "../workers";
import type { Collisions } from "./collisions";
import css from "./index-buffer.module.css";

interface BufferProps {
  run: Collisions;
  /** How far it is: a new number paints anew. */
  count: number;
  label: string | null;
  /** Whether the pixels in which two pieces met are marked. */
  marked?: boolean;
}

/** The index buffer with its pixels as large as they are, and a mark in each where two pieces met. */
export function Buffer({ run, count, label, marked = true }: BufferProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  // biome-ignore lint/correctness/useExhaustiveDependencies: `count` says that `run`, which is one object, has moved on
  useLayoutEffect(() => {
    if (canvas.current && pixels)
      paint(canvas.current, run, Math.min(pixels.width, pixels.height), onDark, marked);
  }, [run, count, pixels, onDark, marked]);
  return <canvas ref={canvas} class={css["buffer"]} {...pictured(label)} />;
}

function paint(
  canvas: HTMLCanvasElement,
  run: Collisions,
  side: number,
  onDark: boolean,
  marked: boolean,
): void {
  canvas.width = side;
  canvas.height = side;
  const context = canvas.getContext("2d");
  if (!context) return;
  const colours = palette(onDark ? "dark" : "light");
  const style = getComputedStyle(canvas);
  const { size, buffer, met } = run;
  const cell = side / size;
  grid(context, size, side, style.getPropertyValue("--line"));
  // Cells meet without seams: each ends where the next begins, on whole pixels.
  const edge = (i: number) => Math.round(i * cell);
  for (let i = 0; i < size * size; i++) {
    const piece = buffer[i] ?? 0;
    if (piece === 0) continue;
    const [column, row] = [i % size, Math.floor(i / size)];
    const [x, y] = [edge(column), edge(row)];
    const [width, height] = [edge(column + 1) - x, edge(row + 1) - y];
    context.fillStyle = colours[(piece - 1) % colours.length] ?? "";
    context.fillRect(x, y, width, height);
    if (marked && (met[i] ?? 0) > 0) mark(context, x, y, width, style);
  }
}

/** The pixels themselves, where they are large enough to be seen. */
function grid(context: CanvasRenderingContext2D, size: number, side: number, colour: string): void {
  if (side / size < 7) return;
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = 1; i < size; i++) {
    const at = Math.round((i * side) / size) - 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, side);
    context.moveTo(0, at);
    context.lineTo(side, at);
  }
  context.stroke();
}

/** A dark square with a light heart: seen on every colour. */
function mark(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  width: number,
  style: CSSStyleDeclaration,
): void {
  const inset = Math.max(0, Math.floor(width * 0.22));
  const inner = width - 2 * inset;
  context.fillStyle = style.getPropertyValue("--ink");
  context.fillRect(x + inset, y + inset, inner, inner);
  if (inner < 5) return;
  const heart = Math.max(1, Math.round(inner * 0.28));
  context.fillStyle = style.getPropertyValue("--stage");
  context.fillRect(x + inset + heart, y + inset + heart, inner - 2 * heart, inner - 2 * heart);
}
