/** What lies on the field and cannot be taken hold of. */
import { pathBreaks } from "#compute/results";
import { pathPoints } from "#document/morph";
import type { Uv } from "#geometry/path";
import { piecesIn, slice, sliced } from "#geometry/polyline";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import { twins } from "./families/families";
import css from "./field.module.css";
import { isOff, isOutside } from "./path/handles";
import { place, toneAt } from "./path/waypoints";
import { family, picked, shownWindow, sides, view } from "./view/view";

export function End({ letter, at: [x, y] }: { letter: string; at: [number, number] }) {
  if (isOutside([x, y])) return null;
  const off = view.value.w !== 0;
  return (
    <span
      class={`locus-end ${off ? "off" : ""}`}
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      aria-hidden="true"
    >
      {letter}
    </span>
  );
}

/** A line as SVG, in hundredths of the square. What lies beyond is left out: deep down its numbers would overflow. */
export function linePath(pieces: readonly [Uv, Uv][]): string {
  const window = shownWindow.value;
  const at = (point: Uv) =>
    place(point, window)
      .map((x) => (100 * x).toFixed(2))
      .join(" ");
  let end = "";
  return pieces
    .map(([from, to]) => {
      const start = at(from);
      const text = start === end ? `L${at(to)}` : `M${start}L${at(to)}`;
      end = at(to);
      return text;
    })
    .join("");
}

/** The window and a little around it, so that caps and joins are drawn outside. */
export function around(): { u0: number; v0: number; u1: number; v1: number } {
  const { u0, v0, u1, v1 } = shownWindow.value;
  const [du, dv] = [0.1 * (u1 - u0), 0.1 * (v1 - v0)];
  return { u0: u0 - du, v0: v0 - dv, u1: u1 + du, v1: v1 + dv };
}

/** How far from the slice the path is still drawn as in it. */
export const THICK = 0.02;

/** The path, and its broken stretches dashed over it; what lies off the slice is faint. */
export function PathLines() {
  const points = pathPoints.value;
  const slicedAt = view.value.w;
  const within = around();
  const { near, far } = sliced(points, slicedAt, THICK);
  const drawn = (line: [Uv, Uv][]) => linePath(line.flatMap((piece) => piecesIn(piece, within)));
  return (
    <svg class="locus-path" viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
      {far.length > 0 && (
        <g class="off">
          <path class="path-casing" d={drawn(far)} />
          <path class="path-core" d={drawn(far)} />
        </g>
      )}
      <path class="path-casing" d={drawn(near)} />
      <path class="path-core" d={drawn(near)} />
      {pathBreaks.value.map(({ t0, t1 }) => {
        const broken = sliced(slice(points, t0, t1), slicedAt, THICK);
        return (
          <g key={`${t0}-${t1}`}>
            <path class="path-casing broken off" d={drawn(broken.far)} />
            <path class="path-core broken off" d={drawn(broken.far)} />
            <path class="path-casing broken" d={drawn(broken.near)} />
            <path class="path-core broken" d={drawn(broken.near)} />
          </g>
        );
      })}
    </svg>
  );
}

/** The parameter that was taken off the path, and, of a family, those that give the same shape. */
export function PickedMark() {
  const at = picked.value;
  if (!at) return null;
  const same = family.value === "polygon" ? twins(sides.value, at) : [];
  return (
    <>
      {same.map((point) => (
        <Mark key={point.join()} point={point} kind="twin" />
      ))}
      <Mark point={at} kind={isOff(at, view.value.w) && family.value === "morph" ? "picked off" : "picked"} />
    </>
  );
}

function Mark({ point, kind }: { point: Uv; kind: string }) {
  const [x, y] = place(point, shownWindow.value);
  if (isOutside([x, y])) return null;
  const tone = toneAt(point);
  return (
    <span
      class={`${css["locus-mark"]} ${kind}`}
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      aria-hidden="true"
    >
      {tone && <VerdictSign tone={tone} />}
    </span>
  );
}
