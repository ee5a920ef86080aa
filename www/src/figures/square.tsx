import { useLayoutEffect, useRef } from "preact/hooks";
import { BOUNDS } from "../engine/locus-job";
import type { LocusResult } from "../engine/results";
import type { Uv } from "../state/path";
import { fieldPixels } from "./field";

export interface SquareProps {
  field: LocusResult | null;
  /** What it shows, in words; null where its surroundings say it. */
  label: string | null;
  lines: readonly { name: string; points: readonly Uv[]; dashed?: boolean }[];
  /** A point to move about, and what moves it. */
  point?: Uv;
  onMove?: (point: Uv) => void;
}

const SPAN = BOUNDS.u1 - BOUNDS.u0;
/** From (u, v) to a square of 300 units, and back. */
const UNITS = 300;
const left = (u: number) => ((u - BOUNDS.u0) / SPAN) * UNITS;
const top = (v: number) => ((BOUNDS.v1 - v) / SPAN) * UNITS;

/** The locus with paths on it. */
export function Square({ field, label, lines, point, onMove }: SquareProps) {
  return (
    <div class="square">
      <FieldCanvas field={field} label={label} />
      <svg viewBox={`0 0 ${UNITS} ${UNITS}`} aria-hidden="true">
        {lines.map((line) => (
          <g key={line.name} class={line.dashed ? "way dashed" : "way"}>
            <path class="halo" d={wayPath(line.points)} />
            <path d={wayPath(line.points)} />
          </g>
        ))}
        <End at={[0, 0]} name="A" />
        <End at={[1, 1]} name="B" />
      </svg>
      {point && onMove && <Handle point={point} onMove={onMove} />}
      {point && !onMove && <Ring point={point} />}
    </div>
  );
}

function wayPath(points: readonly Uv[]): string {
  return points
    .map(([u, v], i) => `${i === 0 ? "M" : "L"}${left(u).toFixed(1)} ${top(v).toFixed(1)}`)
    .join("");
}

function End({ at: [u, v], name }: { at: Uv; name: string }) {
  return (
    <g class="way-end" transform={`translate(${left(u)} ${top(v)})`}>
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
  return (
    <canvas
      ref={canvas}
      class="field"
      {...(label === null ? { "aria-hidden": "true" } : { role: "img", "aria-label": label })}
    />
  );
}

/**
 * The whole square takes the pointer. A finger that begins on the handle drags it any way; elsewhere on the square it
 * still scrolls the page. Keys have the sliders beside the square.
 */
function Handle({ point, onMove }: { point: Uv; onMove: (point: Uv) => void }) {
  const place = useRef<HTMLDivElement>(null);
  const move = (event: PointerEvent) => {
    const box = place.current?.getBoundingClientRect();
    if (!box) return;
    const within = (x: number) => Math.min(1, Math.max(0, x));
    const x = within((event.clientX - box.left) / box.width);
    const y = within((event.clientY - box.top) / box.height);
    onMove([BOUNDS.u0 + x * SPAN, BOUNDS.v1 - y * SPAN]);
  };
  return (
    <div
      ref={place}
      class="square-reach"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        move(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) move(event);
      }}
    >
      <Ring point={point} />
    </div>
  );
}

function Ring({ point: [u, v] }: { point: Uv }) {
  const style = { left: `${(100 * left(u)) / UNITS}%`, top: `${(100 * top(v)) / UNITS}%` };
  return <span class="square-handle" style={style} />;
}
