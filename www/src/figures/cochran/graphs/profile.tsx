import type { ComponentChildren } from "preact";
import type { Size } from "#geometry/coordinates";
import { along, type Scale } from "../../kit/chart/scale";
import { Ticks } from "../../kit/chart/ticks";
import { pictured, pixelRatio, type Sheet, useDrawing } from "../../kit/picture/canvas";
import css from "./profile.module.css";

export interface Line {
  /** t0, x0, t1, x1, .. from left to right. */
  points: Float64Array | readonly number[];
  /** Number in the palette, or the colour of text. */
  colour: number | "ink" | "quiet";
  /** In pixels of the page. */
  width?: number;
  dashed?: boolean;
}

export interface Dots {
  points: Float64Array | readonly number[];
  colour: number | "ink" | "quiet";
  /** Their size, in pixels of the page, and whether they are rings. */
  size?: number;
  hollow?: boolean;
}

/** From (t, x) to pixels of the page, within the plot. */
export type PlaceOf = (t: number, x: number) => [left: number, top: number];

interface ProfileProps {
  /** What is seen, in words; null where its surroundings say it. */
  label: string | null;
  x: Scale & { name?: string };
  y: Scale & { name?: string };
  lines: readonly Line[];
  dots?: readonly Dots[];
  /** Places on the t axis that mean something. */
  rules?: readonly number[];
  /** In pixels of the page. */
  height?: number;
  /** Without axes: as large as its place. */
  bare?: boolean;
  /** What is drawn over it. */
  children?: (place: PlaceOf, size: Size) => ComponentChildren;
}

const HEIGHT = 300;
const MARGIN = { left: 42, right: 12, top: 14, bottom: 30 };
const NONE = { left: 2, right: 2, top: 2, bottom: 2 };

/** Graphs of functions of t, on a canvas; axes and what can be moved lie over it. */
export function Profile(props: ProfileProps) {
  const { label, x, y, lines, dots = [], rules = [], height, bare = false, children } = props;
  const ratio = pixelRatio();
  const margin = bare ? NONE : MARGIN;
  /** The plot on a canvas of so many device pixels. */
  const placed = (all: Size) => {
    const [width, tall] = [all.width / ratio, all.height / ratio];
    const size = {
      width: Math.max(1, width - margin.left - margin.right),
      height: Math.max(1, tall - margin.top - margin.bottom),
    };
    const place: PlaceOf = (t, value) => [along(x, t) * size.width, (1 - along(y, value)) * size.height];
    return { size, place, width, tall };
  };
  const draw = ({ context, colours, token, ...all }: Sheet) => {
    const { size, place } = placed(all);
    context.setTransform(ratio, 0, 0, ratio, margin.left * ratio, margin.top * ratio);
    context.beginPath();
    context.rect(-1, -1, size.width + 2, size.height + 2);
    context.clip();
    const colourOf = (colour: Line["colour"]) =>
      typeof colour === "number"
        ? (colours[colour % colours.length] ?? "")
        : token(colour === "ink" ? "--ink" : "--ink-3");
    context.lineJoin = "round";
    context.strokeStyle = token("--line-strong");
    context.lineWidth = 1;
    context.setLineDash([1, 3]);
    for (const t of rules) trace(context, [t, y.min, t, y.max], place);
    for (const line of lines) {
      context.strokeStyle = colourOf(line.colour);
      context.lineWidth = line.width ?? 1.5;
      context.setLineDash(line.dashed ? [6, 4] : []);
      trace(context, line.points, place);
    }
    context.setLineDash([]);
    for (const group of dots) {
      context.fillStyle = colourOf(group.colour);
      context.strokeStyle = colourOf(group.colour);
      context.lineWidth = 1.25;
      for (let i = 0; i + 1 < group.points.length; i += 2) {
        const [left, top] = place(group.points[i] ?? 0, group.points[i + 1] ?? 0);
        context.beginPath();
        context.arc(left, top, (group.size ?? 4) / 2, 0, 2 * Math.PI);
        if (group.hollow) context.stroke();
        else context.fill();
      }
    }
  };
  const { canvas, pixels } = useDrawing(draw);
  const { size, place, width, tall } = placed(pixels ?? { width: 0, height: 0 });
  return (
    <div
      class={`${css["profile"]} ${bare ? css["bare"] : ""}`}
      style={bare ? {} : { height: `${height ?? HEIGHT}px` }}
    >
      <canvas ref={canvas} {...pictured(label)} />
      {pixels && !bare && (
        <svg width={width} height={tall} aria-hidden="true">
          <g transform={`translate(${margin.left} ${margin.top})`}>
            <Axes x={x} y={y} size={size} />
          </g>
        </svg>
      )}
      {pixels && children && (
        <div
          class={css["profile-over"]}
          style={{
            left: `${margin.left}px`,
            top: `${margin.top}px`,
            width: `${size.width}px`,
            height: `${size.height}px`,
          }}
        >
          {children(place, size)}
        </div>
      )}
    </div>
  );
}

function trace(
  context: CanvasRenderingContext2D,
  points: Float64Array | readonly number[],
  place: PlaceOf,
): void {
  context.beginPath();
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [left, top] = place(points[i] ?? 0, points[i + 1] ?? 0);
    if (i === 0) context.moveTo(left, top);
    else context.lineTo(left, top);
  }
  context.stroke();
}

interface AxesProps {
  x: ProfileProps["x"];
  y: ProfileProps["y"];
  size: Size;
}

function Axes({ x, y, size }: AxesProps) {
  return (
    <g class={css["profile-axes"]}>
      <path d={`M0 0V${size.height}H${size.width}`} />
      <Ticks x={x} y={y} size={size} mark="M-4 0H0" gap={8} />
      {x.name && (
        <text class={css["profile-name"]} x={size.width - 2} y={size.height - 6} text-anchor="end">
          {x.name}
        </text>
      )}
      {y.name && (
        <text class={css["profile-name"]} x={6} y={10}>
          {y.name}
        </text>
      )}
    </g>
  );
}
