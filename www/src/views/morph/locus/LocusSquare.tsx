import { useLayoutEffect, useRef } from "preact/hooks";
import type { Bounds } from "../../../engine/api";
import { type LocusResult, locus, pathBreaks } from "../../../engine/results";
import { pathPoints } from "../../../state/morph";
import type { Uv } from "../../../state/path";
import { pathKind } from "../parts";
import { CurrentHandle, WayHandle } from "./Handles";
import { type LocusStyle, paint } from "./paint";
import { usePathPointer } from "./pointer";
import { slice } from "./polyline";
import { bounds, chosen, place, way } from "./way";

/** The field with the path on it. The square is always shown whole. */
export function LocusSquare({ style }: { style: LocusStyle }) {
  const square = useRef<HTMLDivElement>(null);
  const pointer = usePathPointer(square);
  const field = locus.value;
  const frame = bounds.value;
  const progress = field?.progress ?? 0;
  return (
    <div class={`locus-square ${pathKind.value}`} ref={square} {...pointer}>
      <Field field={field} style={style} />
      <PathLines frame={frame} />
      <End letter="A" at={place([0, 0], frame)} />
      <End letter="B" at={place([1, 1], frame)} />
      <CurrentHandle />
      {way.value.map((point, index) => (
        <WayHandle
          // Way points have no name but their number: it is their key, so that focus stays while one is moved.
          key={index}
          index={index}
          count={way.value.length}
          point={point}
          at={place(point, frame)}
          chosen={chosen.value === index}
        />
      ))}
      {progress < 1 && (
        <div
          class="locus-progress"
          role="progressbar"
          aria-label="Where it holds together, being worked out"
          aria-valuenow={Math.round(100 * progress)}
          style={{ "--progress": String(progress) }}
        />
      )}
    </div>
  );
}

function End({ letter, at: [x, y] }: { letter: string; at: [number, number] }) {
  return (
    <span class="locus-end" style={{ left: `${100 * x}%`, top: `${100 * y}%` }} aria-hidden="true">
      {letter}
    </span>
  );
}

/** Painted in device pixels, so that the patterns are crisp; no finer than the field needs. */
function Field({ field, style }: { field: LocusResult | null; style: LocusStyle }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return;
    const scale = Math.min(2, window.devicePixelRatio || 1);
    const size = Math.max(64, Math.min(1024, Math.round(element.clientWidth * scale)));
    if (element.width !== size) {
      element.width = size;
      element.height = size;
    }
    if (field === null) context.clearRect(0, 0, size, size);
    else context.putImageData(new ImageData(paint(field, size, style, scale), size, size), 0, 0);
  }, [field, style]);
  return (
    <canvas
      ref={canvas}
      class="locus-field"
      width={256}
      height={256}
      role="img"
      aria-label="For every u, to the right, and v, upwards: light where the shape holds together, dark where it is broken"
    />
  );
}

/** The path, and its broken stretches dashed over it. Lengths are hundredths of the square. */
function PathLines({ frame }: { frame: Bounds }) {
  const points = pathPoints.value;
  const line = (part: readonly Uv[]) =>
    part.map((point) => place(point, frame).map((x) => (100 * x).toFixed(2))).join(" ");
  return (
    <svg class="locus-path" viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
      <polyline class="path-casing" points={line(points)} />
      <polyline class="path-core" points={line(points)} />
      {pathBreaks.value.map(({ t0, t1 }) => {
        const part = line(slice(points, t0, t1));
        return (
          <g key={`${t0}-${t1}`}>
            <polyline class="path-casing broken" points={part} />
            <polyline class="path-core broken" points={part} />
          </g>
        );
      })}
    </svg>
  );
}
