import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import type { SpaceView } from "#wasm/api";
import { usePixels } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import { axesOf, orbited } from "../space/eye";
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

export interface MeetViewProps {
  /** The last lies on top. */
  layers: readonly Layer[];
  view: SpaceView;
  /** Whether it is as large as its place allows, however it is turned; else it keeps its size. */
  fitted: boolean;
  onView: (view: SpaceView) => void;
  label: string;
}

const PER_PIXEL = 0.008;
const STEP = Math.PI / 36;

/** Clouds of points over each other, seen from far away. Dragging turns them, and so do the arrow keys. */
export function MeetView({ layers, view, fitted, onView, label }: MeetViewProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  const last = useRef<{ x: number; y: number } | null>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context || !pixels) return;
    element.width = pixels.width;
    element.height = pixels.height;
    const colours = palette(onDark ? "dark" : "light");
    const ink = getComputedStyle(element).getPropertyValue("--ink").trim();
    const ratio = pixels.width / Math.max(1, element.clientWidth);
    const { right, up } = axesOf(view);
    const [tx, ty, tz] = view.target;
    // Without perspective, so that what lies on a line is seen on a line.
    const whole = pixels.height / 2 / (view.distance * Math.tan(view.angle / 2));
    const unit = fitted ? unitOf(layers, view, pixels) : whole;
    for (const { points, colour, size } of layers) {
      context.fillStyle = colour === "ink" ? ink : (colours[colour % colours.length] ?? ink);
      const side = Math.max(1, size * ratio);
      for (let i = 0; i + 2 < points.length; i += 3) {
        const [x, y, z] = [(points[i] ?? 0) - tx, (points[i + 1] ?? 0) - ty, (points[i + 2] ?? 0) - tz];
        const across = x * right[0] + y * right[1] + z * right[2];
        const high = x * up[0] + y * up[1] + z * up[2];
        context.fillRect(
          pixels.width / 2 + unit * across - side / 2,
          pixels.height / 2 - unit * high - side / 2,
          side,
          side,
        );
      }
    }
  }, [layers, view, fitted, pixels, onDark]);
  return (
    <div
      class={css["meet-view"]}
      role="application"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
      tabIndex={0}
      aria-label={`${label} Arrow keys turn it.`}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        last.current = { x: event.clientX, y: event.clientY };
      }}
      onPointerMove={(event) => {
        if (!last.current || !event.currentTarget.hasPointerCapture(event.pointerId)) return;
        const [dx, dy] = [event.clientX - last.current.x, event.clientY - last.current.y];
        last.current = { x: event.clientX, y: event.clientY };
        onView(orbited(view, -PER_PIXEL * dx, PER_PIXEL * dy));
      }}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (!by) return;
        event.preventDefault();
        onView(orbited(view, STEP * (by[0] ?? 0), STEP * (by[1] ?? 0)));
      }}
    >
      <canvas ref={canvas} />
    </div>
  );
}

/** How many pixels a unit of space may have for all to be seen, with a margin. */
function unitOf(
  layers: readonly Layer[],
  view: SpaceView,
  { width, height }: { width: number; height: number },
): number {
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
