import { useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import type { Uv } from "#geometry/path";
import { nearestOn } from "#geometry/polyline";
import { CurrentHandle, focusHandle, WayHandle, type WayPath } from "#stage/locus/WayPoints";
import { MOST_POINTS } from "./morph-edits";
import * as changes from "./waypoints";
import { addHere, goTo, moveTo, removeAt, way } from "./waypoints";
import { moment, pathPoints, uv } from "./work";

/** The path of a morph in space as its handles and its editor have it. */
export const PATH: WayPath = {
  ...changes,
  most: MOST_POINTS,
  moment,
  uv,
  wayWords: changes.stateAt,
};

type ToUv = (event: PointerEvent) => Uv;

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

/** What two presses do: nothing else hears of them. */
const twice = (act: () => void) => (event: MouseEvent) => {
  event.preventDefault();
  event.stopPropagation();
  act();
};

/** A waypoint that a pointer drags; two presses take it away. */
export function Way({ index, toUv }: { index: number; toUv: ToUv }) {
  const hold = useHold(toUv, way.value[index] ?? [0, 0], (to) => moveTo(index, to, `space-way-${index}`));
  const remove = twice(() => {
    removeAt(index);
    focusHandle(null);
  });
  return <WayHandle path={PATH} index={index} pointer={{ ...hold, onDblClick: remove }} />;
}

/** The place on the path, which a pointer drags along it; two presses add a waypoint there. */
export function Current({ toUv }: { toUv: ToUv }) {
  const hold = useHold(toUv, uv.value, (to) => goTo(nearestOn(pathPoints.peek(), to).t));
  return <CurrentHandle path={PATH} pointer={{ ...hold, onDblClick: twice(() => focusHandle(addHere())) }} />;
}
