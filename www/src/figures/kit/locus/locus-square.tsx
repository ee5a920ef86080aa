import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { BOUNDS } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import type { Uv } from "#geometry/path";
import type { Bounds } from "#wasm/api";
import { pictured } from "../picture/canvas";
import { fieldPixels } from "./locus-colours";
import css from "./locus-square.module.css";

interface SquareProps {
  field: LocusResult | null;
  /** What it shows, in words; null where its surroundings say it. */
  label: string | null;
  lines: readonly { name: string; points: readonly Uv[]; dashed?: boolean }[];
  /** A point to move about, and what moves it. */
  point?: Uv;
  onMove?: (point: Uv) => void;
}

interface PlaneProps {
  field: LocusResult | null;
  label: string | null;
  /** A square part of the plane of parameters. */
  bounds: Bounds;
  /** What is drawn over it, with the places of parameters in a square of 300 units. */
  children?: (place: (point: Uv) => [left: number, top: number]) => ComponentChildren;
  point?: Uv;
  onMove?: (point: Uv) => void;
  /** On the ground of the page, until there is a field. */
  plain?: boolean;
}

const UNITS = 300;

/** From parameters to a square of 300 units. */
function placeIn({ u0, u1, v1 }: Bounds): (point: Uv) => [left: number, top: number] {
  const unit = UNITS / (u1 - u0);
  return ([u, v]) => [(u - u0) * unit, (v1 - v) * unit];
}

const place = placeIn(BOUNDS);

/** The locus with paths on it. */
export function Square({ lines, ...plane }: SquareProps) {
  return (
    <Plane {...plane} bounds={BOUNDS}>
      {() => (
        <>
          {lines.map((line) => (
            <g key={line.name} class={`${css["way"]} ${line.dashed ? css["dashed"] : ""}`}>
              <path class={css["halo"]} d={wayPath(line.points)} />
              <path d={wayPath(line.points)} />
            </g>
          ))}
          <End at={[0, 0]} name="A" />
          <End at={[1, 1]} name="B" />
        </>
      )}
    </Plane>
  );
}

/** A part of a plane of parameters, with a point on it that can be moved. */
export function Plane({ field, label, bounds, children, point, onMove, plain = false }: PlaneProps) {
  return (
    <div class={`${css["square"]} ${plain ? css["plain"] : ""}`}>
      <FieldCanvas field={field} label={label} />
      <svg viewBox={`0 0 ${UNITS} ${UNITS}`} aria-hidden="true">
        {children?.(placeIn(bounds))}
      </svg>
      {point && onMove && <Handle point={point} bounds={bounds} onMove={onMove} />}
      {point && !onMove && <Ring point={point} bounds={bounds} />}
    </div>
  );
}

function wayPath(points: readonly Uv[]): string {
  return points
    .map((point, i) => {
      const [x, y] = place(point);
      return `${i === 0 ? "M" : "L"}${x.toFixed(1)} ${y.toFixed(1)}`;
    })
    .join("");
}

function End({ at, name }: { at: Uv; name: string }) {
  return (
    <g class={css["way-end"]} transform={`translate(${place(at).join(" ")})`}>
      <circle r={8} />
      <text dy="0.35em" text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

function FieldCanvas({ field, label }: { field: LocusResult | null; label: string | null }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!canvas.current || !context || !field) return;
    canvas.current.width = field.width;
    canvas.current.height = field.height;
    context.putImageData(new ImageData(fieldPixels(field), field.width, field.height), 0, 0);
  }, [field]);
  return <canvas ref={canvas} class={css["field"]} {...pictured(label)} />;
}

/**
 * The whole square takes the pointer. A finger that begins on the handle drags it any way; elsewhere on the square it
 * still scrolls the page. Keys have the sliders beside the square.
 */
function Handle({ point, bounds, onMove }: { point: Uv; bounds: Bounds; onMove: (point: Uv) => void }) {
  const host = useRef<HTMLDivElement>(null);
  const move = (event: PointerEvent) => {
    const box = host.current?.getBoundingClientRect();
    if (!box) return;
    const within = (x: number) => Math.min(1, Math.max(0, x));
    const x = within((event.clientX - box.left) / box.width);
    const y = within((event.clientY - box.top) / box.height);
    const span = bounds.u1 - bounds.u0;
    onMove([bounds.u0 + x * span, bounds.v1 - y * span]);
  };
  return (
    <div
      ref={host}
      class={css["square-reach"]}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        move(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) move(event);
      }}
    >
      <Ring point={point} bounds={bounds} />
    </div>
  );
}

function Ring({ point, bounds }: { point: Uv; bounds: Bounds }) {
  const [x, y] = placeIn(bounds)(point);
  const style = { left: `${(100 * x) / UNITS}%`, top: `${(100 * y) / UNITS}%` };
  return <span class={css["square-handle"]} style={style} />;
}
