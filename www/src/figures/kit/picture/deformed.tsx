import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { fitFor } from "#document/framing";
import { bentAt } from "#geometry/bezier";
import type { Bend } from "#wasm/api";
import type { Point } from "../maps/pieces";
import type { Place } from "./annotated";
import annotatedCss from "./annotated.module.css";
import css from "./deformed.module.css";
import { Picture, type PictureProps } from "./picture";

/** What is drawn over a picture has these units across. */
const WIDTH = 400;
const MARGIN = 0.03;

interface BentProps extends PictureProps {
  bend: Bend;
  /** Width over height. */
  aspect?: number;
  /** Points a side of the grid that is drawn over it: 0 for none. The paper draws 11. */
  grid?: number;
  children?: (place: Place) => ComponentChildren;
}

/** A shape that is bent, with the display grid of its mesh over it. */
export function Bent({ bend, aspect = 1, grid = 11, children, margin = MARGIN, ...picture }: BentProps) {
  const height = WIDTH / aspect;
  const view = fitFor(picture.box, { width: WIDTH, height }, margin);
  const place: Place = ([x, y]) => [
    WIDTH / 2 + (x - view.x) * view.scale,
    height / 2 - (y - view.y) * view.scale,
  ];
  const points = useMemo(() => (grid > 1 ? gridPoints(bend, grid) : []), [bend, grid]);
  return (
    <div class={`${annotatedCss["drawn"]} ${css["bent"]}`} style={{ "--aspect": String(aspect) }}>
      <Picture {...picture} bend={bend} margin={margin} />
      <svg viewBox={`0 0 ${WIDTH} ${height}`} aria-hidden="true">
        {points.length > 0 && <path class={css["bent-grid"]} d={gridPath(points.map(place), grid)} />}
        {children?.(place)}
      </svg>
    </div>
  );
}

/** Row by row from the lower left. */
function gridPoints(bend: Bend, count: number): Point[] {
  return Array.from({ length: count * count }, (_, i): Point => {
    const column = i % count;
    const [x, y] = bentAt(bend, column / (count - 1), (i - column) / count / (count - 1));
    return [x, y];
  });
}

/** Lines along the rows and along the columns. */
function gridPath(points: readonly Point[], count: number): string {
  const line = (indices: number[]) =>
    `M${indices.map((i) => (points[i] ?? [0, 0]).map((x) => x.toFixed(1)).join(" ")).join("L")}`;
  const numbers = Array.from({ length: count }, (_, i) => i);
  const rows = numbers.map((row) => line(numbers.map((column) => row * count + column)));
  const columns = numbers.map((column) => line(numbers.map((row) => row * count + column)));
  return [...rows, ...columns].join("");
}
