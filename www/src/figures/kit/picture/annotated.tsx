import type { ComponentChildren } from "preact";
import { type Box, fitFor } from "#document/framing";
import type { MapRow } from "#wasm/api";
import { apply, type Point } from "../maps/pieces";
import css from "./annotated.module.css";
import { Picture, type PictureProps } from "./picture";

/** Pictures are 4 to 3, flat ones 2 to 1, square ones 1 to 1; what is drawn over them has these units. */
const WIDTH = 400;
const HEIGHTS = { usual: 300, flat: 200, square: 400 };
const MARGIN = 0.06;

interface DrawnProps extends PictureProps {
  /** What is drawn over it, with the places of the plane; its units are a 400th of the picture's width. */
  children?: (place: Place, unit: number) => ComponentChildren;
  form?: keyof typeof HEIGHTS;
}

export type Place = (point: Point) => Point;

/** An attractor with lines and numbers over it. */
export function Drawn({ children, margin = MARGIN, form = "usual", ...picture }: DrawnProps) {
  const height = HEIGHTS[form];
  const view = fitFor(picture.box, { width: WIDTH, height }, margin);
  const place: Place = ([x, y]) => [
    WIDTH / 2 + (x - view.x) * view.scale,
    height / 2 - (y - view.y) * view.scale,
  ];
  return (
    <div class={`${css["drawn"]} ${form === "usual" ? "" : css[form]}`}>
      <Picture {...picture} margin={margin} />
      <svg viewBox={`0 0 ${WIDTH} ${height}`} aria-hidden="true">
        {children?.(place, view.scale)}
      </svg>
    </div>
  );
}

/** The number of each piece, in its middle or where it is said. */
export function PieceNames({ at }: { at: readonly Point[] }) {
  return (
    <g class={css["piece-names"]}>
      {at.map(([x, y], i) => (
        <g key={`${i + 1}`} transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}>
          <circle />
          <text dy="0.35em" text-anchor="middle">
            {i + 1}
          </text>
        </g>
      ))}
    </g>
  );
}

/** The middles of the pieces of a shape in a box. */
export function middles(maps: readonly MapRow[], box: Box): Point[] {
  const middle: Point = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  return maps.map((map) => apply(map, middle));
}

/** A line between two points with bars at its ends: a distance. */
export function Span({ from, to, name = "", kind = "", awayFrom }: SpanProps) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  const [nx, ny] = length > 0 ? [(5 * dy) / length, (-5 * dx) / length] : [0, 0];
  const middle: Point = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  // The name stands above, or on the side that is turned away from a point.
  const away = awayFrom ? nx * (middle[0] - awayFrom[0]) + ny * (middle[1] - awayFrom[1]) : 1;
  const side = away < 0 ? -2.4 : 2.4;
  const bar = ([x, y]: Point) => `M${x - nx} ${y - ny}L${x + nx} ${y + ny}`;
  const path = `M${from.join(" ")}L${to.join(" ")}${bar(from)}${bar(to)}`;
  return (
    <g class={`${css["span"]} ${css[kind] ?? ""}`}>
      <path class={css["halo"]} d={path} />
      <path d={path} />
      {name !== "" && (
        <text
          x={middle[0] + side * nx}
          y={middle[1] + side * ny}
          dy="0.35em"
          text-anchor={side * nx > 2 ? "start" : side * nx < -2 ? "end" : "middle"}
        >
          {name}
        </text>
      )}
    </g>
  );
}

interface SpanProps {
  from: Point;
  to: Point;
  name?: string;
  kind?: string;
  awayFrom?: Point;
}
