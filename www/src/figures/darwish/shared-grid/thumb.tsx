import { useMemo, useRef } from "preact/hooks";
import { loadDirected } from "#wasm/directed";
import { usePixels } from "../../kit/picture/canvas";
import { gridOf, shapeOf } from "./grids";
import { boxOf, useMeeting } from "./meeting";
import { Drawing } from "./overlay";
import css from "./overlay.module.css";
import type { Shift } from "./shift";

export const needs = [loadDirected];

const SHOWN = { first: true, second: true };
const SHIFT: Shift = [1, 0, 1];

export function Thumb() {
  const frame = useRef<HTMLDivElement>(null);
  const size = usePixels(frame);
  const grid = gridOf("gauss-2");
  const { system } = shapeOf(grid, "dragon");
  const boxes = useMemo(() => [boxOf(system), boxOf(system)] as const, [system]);
  const { layers } = useMeeting({ grid, first: system, second: system, shift: SHIFT, boxes, size });
  return (
    <div ref={frame} class={css["small"]}>
      <Drawing layers={layers} shown={SHOWN} isLine={false} />
    </div>
  );
}
