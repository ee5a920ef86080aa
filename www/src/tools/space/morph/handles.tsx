import "#stage/locus/handles.css";
import { useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import { addStep } from "#format/numbers";
import { percent } from "#format/path-words";
import type { Uv } from "#geometry/path";
import { nearestOn } from "#geometry/polyline";
import { addAfter, addHere, goTo, moveTo, pick, place, pointWords, removeAt, stateAt, stateNow } from "./way";
import { moment, pathPoints, uv } from "./work";

type ToUv = (event: PointerEvent) => Uv;

const idOf = (index: number) => `space-way-${index}`;
const CURRENT = "space-moment";

/** Once it is drawn, which is after the state has changed. */
export function focusHandle(index: number | null): void {
  requestAnimationFrame(() => document.getElementById(index === null ? CURRENT : idOf(index))?.focus());
}

/** The step of one arrow key in u and v: shift a tenth of it, alt ten times. Null for other keys. */
function arrows(event: KeyboardEvent): [du: number, dv: number] | null {
  const step = event.shiftKey ? 0.001 : event.altKey ? 0.1 : 0.01;
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

const styleOf = (point: Uv) => {
  const [x, y] = place(point);
  const within = (p: number) => `${100 * Math.min(1, Math.max(0, p))}%`;
  return { left: within(x), top: within(y) };
};

/** What a pointer does that takes hold of a handle: `to` is told where it goes. */
function useHold(toUv: ToUv, at: Uv, to: (point: Uv) => void) {
  /** From the pointer to the handle, so that it does not jump. */
  const offset = useRef<[number, number] | null>(null);
  const drop = () => {
    if (offset.current) endGesture();
    offset.current = null;
  };
  return {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0 || !(event.currentTarget instanceof HTMLElement)) return;
      event.preventDefault();
      event.currentTarget.setPointerCapture(event.pointerId);
      event.currentTarget.focus({ preventScroll: true });
      const [u, v] = toUv(event);
      offset.current = [at[0] - u, at[1] - v];
    },
    onPointerMove(event: PointerEvent) {
      if (!offset.current) return;
      const [u, v] = toUv(event);
      to([u + offset.current[0], v + offset.current[1]]);
    },
    onPointerUp: drop,
    onPointerCancel: drop,
  };
}

export interface WayHandleProps {
  index: number;
  count: number;
  point: Uv;
  chosen: boolean;
  toUv: ToUv;
}

/** A way point: arrows move it, plus adds one behind it, Delete takes it away. */
export function WayHandle({ index, count, point, chosen, toUv }: WayHandleProps) {
  const [u, v] = point;
  const hold = useHold(toUv, point, (to) => moveTo(index, to, `space-way-${index}`));
  return (
    <div
      id={idOf(index)}
      class={`handle way ${chosen ? "chosen" : ""}`}
      style={styleOf(point)}
      role="slider"
      tabIndex={0}
      aria-label={`Way point ${index + 1} of ${count}`}
      aria-valuenow={u}
      aria-valuemin={-1}
      aria-valuemax={2}
      aria-valuetext={`${pointWords(point)}, ${stateAt(index)}`}
      {...hold}
      onDblClick={(event) => {
        event.preventDefault();
        event.stopPropagation();
        removeAt(index);
        focusHandle(null);
      }}
      onFocus={() => pick(index)}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event);
        if (by) moveTo(index, [addStep(u, by[0]), addStep(v, by[1])], `space-way-${index}`);
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

/** Where on the path the picture is now: arrows move along, plus adds a way point here. */
export function CurrentHandle({ toUv }: { toUv: ToUv }) {
  const t = moment.value;
  const hold = useHold(toUv, uv.value, (to) => goTo(nearestOn(pathPoints.peek(), to).t));
  return (
    <div
      id={CURRENT}
      class={`handle current ${t <= 0 || t >= 1 ? "at-end" : ""}`}
      style={styleOf(uv.value)}
      role="slider"
      tabIndex={0}
      aria-label="Place on the path"
      aria-valuenow={Math.round(1000 * t) / 10}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuetext={`${percent(t)} of the way, ${stateNow()}`}
      {...hold}
      onDblClick={(event) => {
        event.preventDefault();
        event.stopPropagation();
        focusHandle(addHere());
      }}
      onFocus={() => pick(null)}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = arrows(event);
        if (by) goTo(addStep(t, by[0] + by[1]));
        else if (event.key === "Home") goTo(0);
        else if (event.key === "End") goTo(1);
        else if (isAdd(event.key)) focusHandle(addHere());
        else return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={endGesture}
      onBlur={endGesture}
    />
  );
}
