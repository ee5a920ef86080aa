import { useCallback } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { pictured, type Sheet, useDrawing } from "../../kit/picture/canvas";
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

interface OutlineViewProps {
  lines: readonly OutlineLine[];
  box: Box;
  label: string | null;
}

/** Outlines on a canvas. Several with the same box can be compared. */
export function OutlineView({ lines, box, label }: OutlineViewProps) {
  const draw = useCallback(
    ({ context, width, height, ratio, colours, token }: Sheet) => {
      const view = fitFor(box, { width, height }, 0.03);
      const colourOf = (colour: OutlineLine["colour"]) => {
        if (typeof colour === "number") return colours[colour % colours.length] ?? "";
        return token({ ink: "--ink", quiet: "--ink-3", bad: "--bad" }[colour]);
      };
      const place = (points: ArrayLike<number>, i: number): [number, number] => [
        width / 2 + ((points[i] ?? 0) - view.x) * view.scale,
        height / 2 - ((points[i + 1] ?? 0) - view.y) * view.scale,
      ];
      context.lineJoin = "round";
      context.lineCap = "round";
      for (const { points, closed = false, colour, width: thick = 1.5, filled = false, dots } of lines) {
        context.strokeStyle = colourOf(colour);
        context.fillStyle = colourOf(colour);
        context.lineWidth = thick * ratio;
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
    },
    [lines, box],
  );
  const { canvas } = useDrawing(draw);
  return <canvas ref={canvas} class={css["outline-view"]} {...pictured(label)} />;
}
