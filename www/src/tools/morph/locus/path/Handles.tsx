import "#stage/locus/handles.css";
import { uv } from "#document/morph";
import { endGesture, scene } from "#document/scene";
import { addStep } from "#format/numbers";
import { percent } from "#format/path-words";
import type { Uv } from "#geometry/path";
import { pointOf } from "#geometry/polyline";
import { scrubTo } from "../../strip/scrub";
import { shownWindow, view } from "../view/view";
import {
  addAfter,
  addHere,
  chosen,
  moveTo,
  pick,
  place,
  pointWords,
  removeAt,
  stateNow,
  wayWords,
} from "./way";

/** Marks handles in the page: the pointer looks them up by place, keys and tests by this. */
export const handleId = (index: number): string => `way-point-${index}`;
export const CURRENT_ID = "path-moment";

export function focusHandle(index: number | null): void {
  // The handle is drawn after the state has changed.
  requestAnimationFrame(() =>
    document.getElementById(index === null ? CURRENT_ID : handleId(index))?.focus(),
  );
}

/** Where on the square, in parts; what lies beyond it, the chosen and the focused above all, is kept at its edge. */
function at100([x, y]: [number, number]) {
  const within = (p: number) => `${100 * Math.min(1, Math.max(0, p))}%`;
  return { left: within(x), top: within(y) };
}

export const isOutside = ([x, y]: readonly [number, number]): boolean =>
  !(x >= 0 && x <= 1 && y >= 0 && y <= 1);

/** Points nearer to the slice than this lie in it, as far as anyone sees. */
export const THICKNESS = 0.005;
export const isOff = ([, , w = 0]: Uv, slice: number): boolean => Math.abs(w - slice) > THICKNESS;

/** A place on the square as classes: beyond its edge, or off the slice that it shows. */
const whereabouts = (point: Uv, at: [number, number]) =>
  `${isOutside(at) ? "outside" : ""} ${isOff(point, view.value.w) ? "off" : ""}`;

/**
 * The step of one arrow key in u and v: shift a tenth of it, alt ten times. The nearer one looks, the finer. Null for
 * other keys.
 */
function arrows(event: KeyboardEvent, zoom = 1): Uv | null {
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

export interface WayHandleProps {
  index: number;
  count: number;
  point: Uv;
  at: [number, number];
  chosen: boolean;
}

/** A way point: arrows move it, plus adds one behind it, Delete takes it away. */
export function WayHandle({ index, count, point, at, chosen: isChosen }: WayHandleProps) {
  const [u, v, w = 0] = point;
  return (
    <div
      id={handleId(index)}
      class={`handle way ${isChosen ? "chosen" : ""} ${whereabouts(point, at)}`}
      style={at100(at)}
      role="slider"
      tabIndex={0}
      aria-label={`Way point ${index + 1} of ${count}`}
      aria-valuenow={u}
      aria-valuemin={-1}
      aria-valuemax={2}
      aria-valuetext={`${pointWords(point)}, ${wayWords(index)}`}
      onFocus={() => pick(index)}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event, view.peek().zoom);
        if (by !== null) moveTo(index, pointOf(addStep(u, by[0]), addStep(v, by[1]), w), `way-key-${index}`);
        else if (isAdd(event.key)) focusHandle(addAfter(index));
        else if (isRemove(event.key)) {
          removeAt(index);
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

/** Where on the path the picture is now: arrows scrub, plus adds a way point here. */
export function CurrentHandle() {
  const { t } = scene.value;
  const at = uv.value;
  const spot = place(at, shownWindow.value);
  return (
    <div
      id={CURRENT_ID}
      class={`handle current ${t <= 0 || t >= 1 ? "at-end" : ""} ${whereabouts(at, spot)}`}
      style={at100(spot)}
      role="slider"
      tabIndex={0}
      aria-label="Place on the path"
      aria-valuenow={Math.round(1000 * t) / 10}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuetext={`${percent(t)} of the way, ${stateNow()}`}
      onFocus={() => {
        if (chosen.peek() !== null) pick(null);
      }}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event);
        if (by !== null) scrubTo(addStep(t, by[0] + by[1]));
        else if (event.key === "Home") scrubTo(0);
        else if (event.key === "End") scrubTo(1);
        else if (isAdd(event.key)) focusHandle(addHere());
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    />
  );
}
