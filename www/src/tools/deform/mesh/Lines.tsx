import { computed } from "@preact/signals";
import { bentAt, type GridLine, gridLines } from "#geometry/bezier";
import type { Screen } from "#geometry/coordinates";
import { stageSize } from "#stage/view";
import { symmetry } from "./edit";
import { handlesOf, LINES, onStage } from "./hit";
import css from "./mesh.module.css";
import { mesh } from "./mesh-state";
import { frame, grip, under } from "./pointer";

const grid = computed(() => gridLines(mesh.value, LINES));

/** The display grid as the mesh bends it, the net between the control points, and what is being pulled or framed. */
export function Lines() {
  const { width, height } = stageSize.value;
  const lines = grid.value.map(pathOf).join("");
  const middle = (LINES - 1) / 2;
  const by = symmetry.value;
  const axes = [
    ...(by === "sides" || by === "point" ? [grid.value[middle]] : []),
    ...(by === "levels" || by === "point" ? [grid.value[LINES + middle]] : []),
  ];
  return (
    <svg class={css["mesh-lines"]} width={width} height={height} aria-hidden="true">
      <path class={css["mesh-halo"]} d={lines} />
      <path class={css["mesh-grid"]} d={lines} />
      <path class={css["mesh-axis"]} d={axes.map((line) => (line ? pathOf(line) : "")).join("")} />
      <path class={css["mesh-net"]} d={netOf(handlesOf(mesh.value))} />
      <Spot />
      <Frame />
    </svg>
  );
}

/** Where the mesh is pulled, or would be. */
function Spot() {
  const place = grip.value;
  const hint = under.value;
  const at = place ? onStage(bentAt(mesh.value, ...place)) : typeof hint === "number" ? null : hint;
  return (
    at && (
      <circle
        class={place ? `${css["mesh-spot"]} ${css["held"]}` : css["mesh-spot"]}
        cx={at.x}
        cy={at.y}
        r={place ? 6 : 4}
      />
    )
  );
}

function Frame() {
  if (!frame.value) return null;
  const [p, q] = frame.value;
  return (
    <rect
      class={css["mesh-frame"]}
      x={Math.min(p.x, q.x)}
      y={Math.min(p.y, q.y)}
      width={Math.abs(p.x - q.x)}
      height={Math.abs(p.y - q.y)}
    />
  );
}

/** One smooth line; what of it lies off the stage is left out. */
function pathOf({ points, headings }: GridLine): string {
  let d = "";
  let drawn = false;
  points.forEach(([x, y], i) => {
    const [px, py] = points[i - 1] ?? [x, y];
    const [hx, hy] = headings[i - 1] ?? [0, 0];
    const [kx, ky] = headings[i] ?? [0, 0];
    if (i === 0) return;
    const from = onStage([px, py]);
    const bow = [onStage([px + hx / 3, py + hy / 3]), onStage([x - kx / 3, y - ky / 3]), onStage([x, y])];
    if (!seen([from, ...bow])) {
      drawn = false;
      return;
    }
    if (!drawn) d += `M${at(from)}`;
    d += `C${bow.map(at).join(" ")}`;
    drawn = true;
  });
  return d;
}

/** Straight lines between neighbouring control points. */
function netOf(points: readonly Screen[]): string {
  const { columns } = mesh.value;
  let d = "";
  points.forEach((p, i) => {
    const right = (i + 1) % columns === 0 ? undefined : points[i + 1];
    for (const q of [right, points[i + columns]]) if (q && seen([p, q])) d += `M${at(p)}L${at(q)}`;
  });
  return d;
}

/** Beyond, a drawing of a line is not to be trusted. */
const FARTHEST_PIXEL = 1e6;

/** Whether some of it may be on the stage: points that are not all beyond one side of it. */
function seen(points: readonly Screen[]): boolean {
  const { width, height } = stageSize.value;
  return (
    points.every(({ x, y }) => Math.abs(x) < FARTHEST_PIXEL && Math.abs(y) < FARTHEST_PIXEL) &&
    points.some(({ x }) => x >= 0) &&
    points.some(({ x }) => x <= width) &&
    points.some(({ y }) => y >= 0) &&
    points.some(({ y }) => y <= height)
  );
}

function at({ x, y }: Screen): string {
  return `${x.toFixed(1)} ${y.toFixed(1)}`;
}
