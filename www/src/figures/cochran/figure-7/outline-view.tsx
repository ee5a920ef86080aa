import { useLayoutEffect, useRef } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { usePixels } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import css from "./outline-view.module.css";

export interface OutlineLine {
  /** x0, y0, x1, y1, .. with y up. */
  points: ArrayLike<number>;
  closed?: boolean;
  colour: number | "ink" | "quiet" | "bad";
  /** In pixels of the page. */
  width?: number;
  filled?: boolean;
  /** Only the points, as dots of this size. */
  dots?: number;
}

export interface OutlineViewProps {
  lines: readonly OutlineLine[];
  box: Box;
  label: string | null;
}

/** Outlines on a canvas. Several with the same box can be compared. */
export function OutlineView({ lines, box, label }: OutlineViewProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context || !pixels) return;
    element.width = pixels.width;
    element.height = pixels.height;
    const view = fitFor(box, pixels, 0.03);
    const style = getComputedStyle(element);
    const colours = palette(onDark ? "dark" : "light");
    const ratio = Math.min(2, globalThis.devicePixelRatio || 1);
    const colourOf = (colour: OutlineLine["colour"]) => {
      if (typeof colour === "number") return colours[colour % colours.length] ?? "";
      return style.getPropertyValue({ ink: "--ink", quiet: "--ink-3", bad: "--bad" }[colour]);
    };
    const place = (points: ArrayLike<number>, i: number): [number, number] => [
      pixels.width / 2 + ((points[i] ?? 0) - view.x) * view.scale,
      pixels.height / 2 - ((points[i + 1] ?? 0) - view.y) * view.scale,
    ];
    context.lineJoin = "round";
    context.lineCap = "round";
    for (const { points, closed = false, colour, width = 1.5, filled = false, dots } of lines) {
      context.strokeStyle = colourOf(colour);
      context.fillStyle = colourOf(colour);
      context.lineWidth = width * ratio;
      context.beginPath();
      for (let i = 0; i + 1 < points.length; i += 2) {
        const [x, y] = place(points, i);
        if (dots !== undefined) {
          context.moveTo(x, y);
          context.arc(x, y, (dots * ratio) / 2, 0, 2 * Math.PI);
        } else if (i === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      }
      if (dots !== undefined) {
        context.fill();
        continue;
      }
      if (closed) context.closePath();
      if (filled) {
        context.globalAlpha = 0.16;
        context.fill();
        context.globalAlpha = 1;
      }
      context.stroke();
    }
  }, [lines, box, pixels, onDark]);
  return (
    <canvas
      ref={canvas}
      class={css["outline-view"]}
      {...(label === null ? { "aria-hidden": "true" } : { role: "img", "aria-label": label })}
    />
  );
}

/** The box of points. */
export function boxOfPoints(points: ArrayLike<number>): Box {
  const box = {
    x0: Number.POSITIVE_INFINITY,
    y0: Number.POSITIVE_INFINITY,
    x1: Number.NEGATIVE_INFINITY,
    y1: Number.NEGATIVE_INFINITY,
  };
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [points[i] ?? 0, points[i + 1] ?? 0];
    box.x0 = Math.min(box.x0, x);
    box.y0 = Math.min(box.y0, y);
    box.x1 = Math.max(box.x1, x);
    box.y1 = Math.max(box.y1, y);
  }
  return Number.isFinite(box.x0) ? box : { x0: 0, y0: 0, x1: 1, y1: 1 };
}
