/** The waypoints of a path through a map of parameters, and the place on it, as handles. */
import "./handles.css";
import type { ReadonlySignal } from "@preact/signals";
import type { HTMLAttributes } from "preact";
import { endGesture } from "#document/scene";
import { addStep } from "#format/numbers";
import { percent } from "#format/path-words";
import type { VerdictWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import * as messages from "../messages";

/** A path as hands and keys change it. */
export interface WayPath {
  /** Points between the two ends, and the one of them whose numbers are shown. */
  way: ReadonlySignal<Uv[]>;
  chosen: ReadonlySignal<number | null>;
  /** How many a link can hold. */
  most: number;
  pick(index: number | null): void;
  /** At its own third number, where none is given. */
  moveTo(index: number, point: Uv, gesture: string): void;
  /** The number of the new one; null where none can be added. */
  addAfter(index: number): number | null;
  addHere(): number | null;
  removeAt(index: number): void;
  /** Where the picture is now: as a part of the path, and as a point. */
  moment: ReadonlySignal<number>;
  uv: ReadonlySignal<Uv>;
  goTo(t: number): void;
  /** What is known of a waypoint, of the present moment, and how a point is called. */
  wayWords(index: number): string;
  stateNow(): string;
  /** What the stage has said of the shape at a point. It holds there alone, whatever the samples around it show. */
  toneAt?(point: Uv): VerdictWords["tone"] | null;
  pointWords(point: Uv): string;
  /** Where a point lies on the square that is shown: parts from its left and from its top. */
  place(point: Uv): [x: number, y: number];
  /** More classes of a handle there. */
  look?(point: Uv): string;
  /** How much the square is enlarged. The nearer one looks, the finer keys are. */
  zoom?(): number;
}

/** Marks handles in the page: pointers look them up by place, keys and tests by this. */
export const handleId = (index: number): string => `way-point-${index}`;
export const CURRENT_ID = "path-moment";

/** Once it is drawn, which is after the state has changed. */
export function focusHandle(index: number | null): void {
  requestAnimationFrame(() =>
    document.getElementById(index === null ? CURRENT_ID : handleId(index))?.focus(),
  );
}

/** What lies beyond the square, the chosen and the focused above all, is kept at its edge. */
function styleAt([x, y]: [number, number]) {
  const within = (p: number) => `${100 * Math.min(1, Math.max(0, p))}%`;
  return { left: within(x), top: within(y) };
}

/** The step of one arrow key in u and v: shift a tenth of it, alt ten times. Null for other keys. */
function arrows(event: KeyboardEvent, zoom = 1): [du: number, dv: number] | null {
  const fine = 10 ** -Math.floor(Math.log10(zoom) + 1e-9);
  const step = (event.shiftKey ? 0.001 : event.altKey ? 0.1 : 0.01) * fine;
  switch (event.key) {
    case "ArrowRight":
      return [step, 0];
    case "ArrowLeft":
      return [-step, 0];
    case "ArrowUp":
      return [0, step];
    case "ArrowDown":
      return [0, -step];
    default:
      return null;
  }
}

const isAdd = (key: string) => key === "+" || key === "Insert" || key === "Enter";
const isRemove = (key: string) => key === "Delete" || key === "Backspace" || key === "-";

interface HandleProps {
  path: WayPath;
  /** What pointers do. */
  pointer?: HTMLAttributes<HTMLDivElement>;
}

/** A waypoint: arrows move it, plus adds one behind it, Delete takes it away. */
export function WayHandle({ path, index, pointer }: HandleProps & { index: number }) {
  const count = path.way.value.length;
  const point = path.way.value[index] ?? [0, 0];
  const [u, v] = point;
  return (
    <div
      id={handleId(index)}
      class={`handle way ${path.chosen.value === index ? "chosen" : ""} ${path.look?.(point) ?? ""}`}
      style={styleAt(path.place(point))}
      role="slider"
      tabIndex={0}
      aria-label={messages.waypointOf(index + 1, count)}
      aria-valuenow={u}
      aria-valuemin={-1}
      aria-valuemax={2}
      aria-valuetext={`${path.pointWords(point)}, ${path.wayWords(index)}`}
      {...pointer}
      onFocus={() => path.pick(index)}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event, path.zoom?.());
        if (by) path.moveTo(index, [addStep(u, by[0]), addStep(v, by[1])], `way-key-${index}`);
        else if (isAdd(event.key)) focusHandle(path.addAfter(index));
        else if (isRemove(event.key)) {
          path.removeAt(index);
          focusHandle(count > 1 ? Math.max(0, index - 1) : null);
        } else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={endGesture}
      onBlur={endGesture}
    />
  );
}

/** Where on the path the picture is now: arrows move along, plus adds a waypoint here. */
export function CurrentHandle({ path, pointer }: HandleProps) {
  const t = path.moment.value;
  const at = path.uv.value;
  const tone = path.toneAt?.(at);
  return (
    <div
      id={CURRENT_ID}
      class={`handle current ${t <= 0 || t >= 1 ? "at-end" : ""} ${path.look?.(at) ?? ""}`}
      style={styleAt(path.place(at))}
      role="slider"
      tabIndex={0}
      aria-label={messages.positionOnPath}
      aria-valuenow={Math.round(1000 * t) / 10}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuetext={messages.placeOnPath(percent(t), path.stateNow())}
      {...pointer}
      onFocus={() => path.pick(null)}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event);
        if (by) path.goTo(addStep(t, by[0] + by[1]));
        else if (event.key === "Home") path.goTo(0);
        else if (event.key === "End") path.goTo(1);
        else if (isAdd(event.key)) focusHandle(path.addHere());
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={endGesture}
      onBlur={endGesture}
    >
      {tone && <VerdictSign tone={tone} />}
    </div>
  );
}
