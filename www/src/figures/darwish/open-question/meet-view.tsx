import { useCallback } from "preact/hooks";
import type { Size } from "#geometry/coordinates";
import type { SpaceView } from "#wasm/api";
import { type Sheet, useDrawing } from "../../kit/picture/canvas";
import { axesOf } from "../space/eye";
import { useOrbit } from "../space/orbit";
import css from "./meet-view.module.css";

export interface Layer {
  name: string;
  /** x0, y0, z0, x1, .. */
  points: Float32Array;
  /** A colour of the palette, or the ink of the page. */
  colour: number | "ink";
  /** Pixels of a screen of ordinary fineness. */
  size: number;
}

interface MeetViewProps {
  /** The last lies on top. */
  layers: readonly Layer[];
  view: SpaceView;
  /** Whether it is as large as its place allows, however it is turned; else it keeps its size. */
  fitted: boolean;
  onView: (view: SpaceView) => void;
  label: string;
}

/** Clouds of points over each other, seen from far away. Dragging turns them, and so do the arrow keys. */
export function MeetView({ layers, view, fitted, onView, label }: MeetViewProps) {
  const draw = useCallback(
    ({ context, width, height, ratio, colours, token }: Sheet) => {
      const ink = token("--ink");
      const { right, up } = axesOf(view);
      const [tx, ty, tz] = view.target;
      // Without perspective, so that what lies on a line is seen on a line.
      const whole = height / 2 / (view.distance * Math.tan(view.angle / 2));
      const unit = fitted ? unitOf(layers, view, { width, height }) : whole;
      for (const { points, colour, size } of layers) {
        context.fillStyle = colour === "ink" ? ink : (colours[colour % colours.length] ?? ink);
        const side = Math.max(1, size * ratio);
        for (let i = 0; i + 2 < points.length; i += 3) {
          const [x, y, z] = [(points[i] ?? 0) - tx, (points[i + 1] ?? 0) - ty, (points[i + 2] ?? 0) - tz];
          const across = x * right[0] + y * right[1] + z * right[2];
          const high = x * up[0] + y * up[1] + z * up[2];
          context.fillRect(
            width / 2 + unit * across - side / 2,
            height / 2 - unit * high - side / 2,
            side,
            side,
          );
        }
      }
    },
    [layers, view, fitted],
  );
  const { canvas } = useDrawing(draw);
  const orbit = useOrbit(view, onView);
  return (
    <div class={css["meet-view"]} role="application" aria-label={`${label} Arrow keys turn it.`} {...orbit}>
      <canvas ref={canvas} />
    </div>
  );
}

/** How many pixels a unit of space may have for all to be seen, with a margin. */
function unitOf(layers: readonly Layer[], view: SpaceView, { width, height }: Size): number {
  const { right, up } = axesOf(view);
  const [tx, ty, tz] = view.target;
  let [across, high] = [0, 0];
  for (const { points } of layers) {
    for (let i = 0; i + 2 < points.length; i += 3) {
      const [x, y, z] = [(points[i] ?? 0) - tx, (points[i + 1] ?? 0) - ty, (points[i + 2] ?? 0) - tz];
      across = Math.max(across, Math.abs(x * right[0] + y * right[1] + z * right[2]));
      high = Math.max(high, Math.abs(x * up[0] + y * up[1] + z * up[2]));
    }
  }
  return 0.46 * Math.min(width / Math.max(across, 1e-9), height / Math.max(high, 1e-9));
}
