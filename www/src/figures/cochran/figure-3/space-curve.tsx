import { useCallback } from "preact/hooks";
import { pictured, type Sheet, useDrawing } from "../../kit/picture/canvas";
import { useDrag } from "../../kit/picture/drag";
import { CORNERS, type SpacePoint } from "../graphs/arrowhead";
import css from "./space-curve.module.css";

/** From where it is looked at, in degrees: round the upright axis, and up. */
export interface Eye {
  turn: number;
  tilt: number;
}

interface SpaceViewProps {
  points: readonly SpacePoint[];
  eye: Eye;
  /** Whether the three shadows on the walls are drawn. */
  shadows: boolean;
  label: string | null;
  /** The one of the three pieces that is shown alone, from 0; the others are thin. */
  piece?: number | null;
  onTurn?: (eye: Eye) => void;
}

export const STEEPEST = 90;
/** All three shadows at once. */
export const FROM_CORNER: Eye = { turn: -35, tilt: 24 };

/** Half an edge of the box: t runs along it, x across, and the height is y. */
const HALF: readonly [number, number, number] = [0.5, 0.5, CORNERS.B[1] / 2];
const FIT = 0.56;
const PER_PIXEL = 0.5;

type Space = readonly [t: number, x: number, y: number];
type Flat = readonly [left: number, top: number];

/** Where a point of the box is on a canvas of unit size, seen from far away. */
function projector({ turn, tilt }: Eye): (p: Space) => Flat {
  const [s, c] = [Math.sin((turn * Math.PI) / 180), Math.cos((turn * Math.PI) / 180)];
  const [up, flat] = [Math.sin((tilt * Math.PI) / 180), Math.cos((tilt * Math.PI) / 180)];
  return ([t, x, y]) => {
    const [dt, dx, dy] = [t - HALF[0], x - HALF[1], y - HALF[2]];
    const across = dt * c - dx * s;
    const away = dt * s + dx * c;
    return [0.5 + FIT * across, 0.5 - FIT * (away * up + dy * flat)];
  };
}

/** The wall of each axis that lies behind: 0 or the far end. */
function wallsBehind({ turn, tilt }: Eye): Space {
  const [s, c] = [Math.sin((turn * Math.PI) / 180), Math.cos((turn * Math.PI) / 180)];
  return [s >= 0 ? 1 : 0, c >= 0 ? 1 : 0, tilt >= 0 ? 0 : CORNERS.B[1]];
}

/** The space curve in its box. Dragging turns it; what is done with keys, sliders beside it do. */
export function SpaceView({ points, eye, shadows, label, piece = null, onTurn }: SpaceViewProps) {
  const named = label !== null;
  const draw = useCallback(
    ({ context, width, height, colours, token }: Sheet) => {
      const side = Math.min(width, 1.15 * height);
      context.translate((width - side) / 2, (height - side) / 2);
      const project = projector(eye);
      const place = (p: Space): Flat => {
        const [left, top] = project(p);
        return [left * side, top * side];
      };
      const stroke = (line: readonly Space[], colour: string, thick: number) => {
        context.beginPath();
        for (const [i, p] of line.entries()) context[i === 0 ? "moveTo" : "lineTo"](...place(p));
        context.strokeStyle = colour;
        context.lineWidth = thick * Math.max(side / 420, 0.6);
        context.stroke();
      };
      context.lineJoin = "round";
      box(eye, (line) => stroke(line, token("--line"), 1));
      if (shadows) {
        for (const shadow of shadowsOf(points, wallsBehind(eye))) {
          stroke(shadow, token("--ink-3"), 0.8);
        }
      }
      const third = Math.floor(points.length / 3);
      for (const [i, colour] of [0, 1, 2].entries()) {
        const part = points.slice(i * third, i === 2 ? points.length : (i + 1) * third + 1);
        stroke(
          part.map(({ t, x, y }): Space => [t, x, y]),
          piece === null || piece === i ? (colours[colour] ?? "") : token("--ink-3"),
          piece === null || piece === i ? 2 : 0.8,
        );
      }
      if (named) names(context, place, token("--ink-2"), side);
    },
    [points, eye, shadows, named, piece],
  );
  const { canvas } = useDrawing(draw);
  const drag = useDrag((dx, dy) =>
    onTurn?.({ turn: wrapped(eye.turn + PER_PIXEL * dx), tilt: steep(eye.tilt + PER_PIXEL * dy) }),
  );
  return (
    <canvas
      ref={canvas}
      class={`${css["space-view"]} ${onTurn ? css["turned"] : ""} ${label === null ? css["small"] : ""}`}
      {...pictured(label)}
      {...(onTurn ? drag : {})}
    />
  );
}

/** Between -180 and 180. */
export function wrapped(turn: number): number {
  return ((((turn + 180) % 360) + 360) % 360) - 180;
}

function steep(tilt: number): number {
  return Math.min(STEEPEST, Math.max(-STEEPEST, tilt));
}

/** The curve on the floor (t and x), on the wall behind it (t and y) and on the side wall (x and y). */
function shadowsOf(points: readonly SpacePoint[], [wt, wx, wy]: Space): Space[][] {
  return [
    points.map(({ t, x }): Space => [t, x, wy]),
    points.map(({ t, y }): Space => [t, wx, y]),
    points.map(({ x, y }): Space => [wt, x, y]),
  ];
}

/** The edges of the three walls behind. */
function box(eye: Eye, stroke: (line: readonly Space[]) => void): void {
  const [wt, wx, wy] = wallsBehind(eye);
  const top = CORNERS.B[1];
  stroke([
    [0, 0, wy],
    [1, 0, wy],
    [1, 1, wy],
    [0, 1, wy],
    [0, 0, wy],
  ]);
  stroke([
    [0, wx, 0],
    [1, wx, 0],
    [1, wx, top],
    [0, wx, top],
    [0, wx, 0],
  ]);
  stroke([
    [wt, 0, 0],
    [wt, 1, 0],
    [wt, 1, top],
    [wt, 0, top],
    [wt, 0, 0],
  ]);
}

function names(
  context: CanvasRenderingContext2D,
  place: (p: Space) => Flat,
  colour: string,
  side: number,
): void {
  context.fillStyle = colour;
  context.font = `${Math.max(12, side / 32)}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [name, p] of [
    ["t", [0.5, -0.08, 0]],
    ["x", [-0.08, 0.5, 0]],
    ["y", [-0.05, -0.05, HALF[2]]],
  ] as const) {
    context.fillText(name, ...place(p));
  }
}
