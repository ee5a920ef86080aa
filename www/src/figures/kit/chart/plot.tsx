import { useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import type { Size } from "#geometry/coordinates";
import { palette } from "#style/palette";
import { useWidth } from "../picture/canvas";
import css from "./plot.module.css";
import { along, linePath, type Scale } from "./scale";
import { Ticks } from "./ticks";

export interface Series {
  name: string;
  points: readonly (readonly [x: number, y: number])[];
  /** Which colour of the palette; each has its own dashes too. */
  colour: number;
  dashed?: boolean;
  /** Marks at the points. */
  dots?: boolean;
  /** Where along it its name stands, by point number; the last by default. */
  nameAt?: number;
  /** Pixels by which the name is raised. */
  raise?: number;
}

interface PlotProps {
  /** What it shows, in a sentence with numbers. */
  label: string;
  x: Scale & { name: string };
  y: Scale & { name: string };
  series: readonly Series[];
  /** Where on the x axis the present moment is. */
  now?: number;
  /** Places on the x axis that mean something: what was guessed, dashed, and what is so. */
  marks?: readonly { at: number; name: string; guess?: boolean }[];
  /** A level on the y axis that means something. */
  level?: { at: number; name: string };
  /** In pixels. */
  height?: number;
}

const HEIGHT = 216;
const MARGIN = { left: 50, right: 14, top: 28, bottom: 36 };

/** A few curves over one axis. */
export function Plot({ label, x, y, series, now, level, marks = [], height = HEIGHT }: PlotProps) {
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const size = {
    width: Math.max(0, width - MARGIN.left - MARGIN.right),
    height: height - MARGIN.top - MARGIN.bottom,
  };
  const colours = palette(dark.value ? "dark" : "light");
  const left = (value: number) => along(x, value) * size.width;
  const top = (value: number) => (1 - along(y, value)) * size.height;
  return (
    <div class={css["plot"]} ref={host} style={{ "--plot-height": `${height}px` }}>
      {size.width > 0 && (
        <svg width={width} height={height} viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
          <g transform={`translate(${MARGIN.left} ${MARGIN.top})`}>
            <Axes x={x} y={y} size={size} />
            {level && (
              <g class={css["plot-level"]}>
                <path d={`M0 ${top(level.at)}H${size.width}`} />
                <text x={size.width} y={top(level.at) - 5} text-anchor="end">
                  {level.name}
                </text>
              </g>
            )}
            {now !== undefined && <path class={css["plot-now"]} d={`M${left(now)} 0V${size.height}`} />}
            {marks.map(({ at, name, guess }, i) => (
              <g key={name} class={`${css["plot-mark"]} ${guess ? css["guess"] : ""}`}>
                <path d={`M${left(at)} 0V${size.height}`} />
                <text
                  x={left(at) + (left(at) > 0.7 * size.width ? -5 : 5)}
                  y={12 + 16 * i}
                  text-anchor={left(at) > 0.7 * size.width ? "end" : "start"}
                >
                  {name}
                </text>
              </g>
            ))}
            {series.map((one) => (
              <Curve key={one.name} series={one} x={x} y={y} size={size} colour={colours[one.colour] ?? ""} />
            ))}
          </g>
        </svg>
      )}
    </div>
  );
}

function Axes({ x, y, size }: { x: PlotProps["x"]; y: PlotProps["y"]; size: Size }) {
  return (
    <g class={css["plot-axes"]}>
      <Ticks x={x} y={y} size={size} mark={`M0 0H${size.width}`} gap={7} />
      <text x={size.width} y={size.height + 31} text-anchor="end">
        {x.name}
      </text>
      <text x={-MARGIN.left + 2} y={-14}>
        {y.name}
      </text>
    </g>
  );
}

interface CurveProps {
  series: Series;
  x: Scale;
  y: Scale;
  size: Size;
  colour: string;
}

function Curve({ series, x, y, size, colour }: CurveProps) {
  const { name, points, dashed = false, dots = false, raise = 8 } = series;
  const at = points[series.nameAt ?? points.length - 1];
  const place = ([px, py]: readonly [number, number]) =>
    [along(x, px) * size.width, (1 - along(y, py)) * size.height] as const;
  const [nameX, nameY] = at ? place(at) : [0, 0];
  return (
    <g class={css["plot-curve"]} style={{ color: colour }}>
      <path d={linePath(points, x, y, size)} stroke-dasharray={dashed ? "5 4" : undefined} />
      {dots &&
        points.map((point) => {
          const [cx, cy] = place(point);
          return Number.isFinite(cx + cy) ? <circle key={point[0]} cx={cx} cy={cy} r={3.5} /> : null;
        })}
      {at && Number.isFinite(nameX + nameY) && (
        <text
          x={nameX}
          y={nameY - raise}
          text-anchor={nameX > 0.75 * size.width ? "end" : nameX < 0.25 * size.width ? "start" : "middle"}
        >
          {name}
        </text>
      )}
    </g>
  );
}
