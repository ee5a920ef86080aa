import type { ComponentChildren } from "preact";
import { useCallback } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { channelsOf } from "#style/hex";
import type { Place } from "../../kit/picture/annotated";
import { pictured, type Sheet, useDrawing } from "../../kit/picture/canvas";
import { type Game, shades, tally } from "./dice";
import css from "./shade.module.css";

interface ShadeProps {
  game: Game;
  box: Box;
  label: string | null;
  /** Width over height. */
  shape?: number;
  /** The side of a cell in which marks are counted, in pixels of the page. */
  grain?: number;
  /** Drawn over it; the picture is 400 units wide. */
  children?: (place: Place) => ComponentChildren;
}

const WIDTH = 400;
const MARGIN = 0.05;
/** Which colour of the palette the marks have. */
const INK = 1;

/** The marks of a game: the more there are in a place, the stronger its colour. */
export function Shade({ game, box, label, shape = 4 / 3, grain = 1, children }: ShadeProps) {
  const draw = useCallback((sheet: Sheet) => paint(sheet, game, box, grain), [game, box, grain]);
  const { canvas } = useDrawing(draw);
  const height = WIDTH / shape;
  const view = fitFor(box, { width: WIDTH, height }, MARGIN);
  const place: Place = ([x, y]) => [
    WIDTH / 2 + (x - view.x) * view.scale,
    height / 2 - (y - view.y) * view.scale,
  ];
  return (
    <div class={css["shade"]} style={{ "--shape": String(shape) }}>
      <canvas ref={canvas} {...pictured(label)} />
      {children && (
        <svg viewBox={`0 0 ${WIDTH} ${height}`} aria-hidden="true">
          {children(place)}
        </svg>
      )}
    </div>
  );
}

function paint({ context, width, height, ratio, colours }: Sheet, game: Game, box: Box, grain: number): void {
  const cell = Math.max(1, Math.round(grain * ratio));
  const [columns, rows] = [Math.ceil(width / cell), Math.ceil(height / cell)];
  const view = fitFor(box, { width, height }, MARGIN);
  // The last cells may reach beyond the picture: their middle is not its middle.
  const x = view.x + (columns * cell - width) / 2 / view.scale;
  const y = view.y - (rows * cell - height) / 2 / view.scale;
  const dark = shades(tally(game, { columns, rows, view: { x, y, scale: view.scale / cell } }));
  const [red = 0, green = 0, blue = 0] = channelsOf(colours[INK] ?? "");
  const image = new ImageData(columns, rows);
  for (const [i, shade] of dark.entries()) image.data.set([red, green, blue, 255 * shade], 4 * i);
  const small = document.createElement("canvas");
  small.width = columns;
  small.height = rows;
  small.getContext("2d")?.putImageData(image, 0, 0);
  context.imageSmoothingEnabled = false;
  context.drawImage(small, 0, 0, columns * cell, rows * cell);
}
