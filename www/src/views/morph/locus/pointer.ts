import type { RefObject } from "preact";
import { useRef } from "preact/hooks";
import { pathPoints, uv } from "../../../state/morph";
import type { Uv } from "../../../state/path";
import { endGesture } from "../../../state/scene";
import { scrubTo } from "../strip/scrub";
import { CURRENT_ID, handleId } from "./Handles";
import { hitHandle, nearestOn } from "./polyline";
import { addAt, bounds, moveTo, pick, removeAt, way } from "./way";

/** A hand must travel this far, in CSS pixels, before it drags: a tap stays a tap. */
const SLACK = 4;
/** Holding a finger still for so long takes a way point away. */
const LONG_PRESS_MS = 600;

interface Drag {
  pointer: number;
  /** A way point by number, or the place on the path. */
  what: number | "moment";
  /** From the handle to where it was taken hold of, so that it does not jump. */
  offset: Uv;
  start: [x: number, y: number];
  moved: boolean;
  timer: ReturnType<typeof setTimeout> | null;
}

/**
 * Dragging way points and the place on the path, adding by a double click or tap, taking away by the same on a way point
 * or by a long press. Hits are decided by nearness, so handles that lie on each other can all be reached.
 */
export function usePathPointer(square: RefObject<HTMLElement | null>) {
  const drag = useRef<Drag | null>(null);

  const toUv = (event: MouseEvent): { point: Uv; perPixel: number } => {
    const box = square.current?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1);
    const { u0, v0, u1, v1 } = bounds.peek();
    const x = (event.clientX - box.left) / box.width;
    const y = (event.clientY - box.top) / box.height;
    return { point: [u0 + x * (u1 - u0), v1 - y * (v1 - v0)], perPixel: (u1 - u0) / box.width };
  };
  /** The way point under a press, else the place on the path, else null. */
  const hit = (point: Uv, reach: number): Drag["what"] | null => {
    const points = way.peek();
    const index = hitHandle([...points, uv.peek()], point, reach);
    if (index < 0) return null;
    return index < points.length ? index : "moment";
  };
  const finish = (cancel: boolean) => {
    const done = drag.current;
    if (done === null) return;
    if (done.timer !== null) clearTimeout(done.timer);
    drag.current = null;
    if (cancel || done.moved) endGesture();
  };

  return {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0 || drag.current !== null) return;
      const { point, perPixel } = toUv(event);
      const coarse = event.pointerType !== "mouse";
      const what = hit(point, perPixel * (coarse ? 24 : 12));
      if (what === null) {
        pick(null);
        return;
      }
      event.preventDefault();
      const handle = what === "moment" ? uv.peek() : (way.peek()[what] ?? point);
      document
        .getElementById(what === "moment" ? CURRENT_ID : handleId(what))
        ?.focus({ preventScroll: true });
      square.current?.setPointerCapture(event.pointerId);
      drag.current = {
        pointer: event.pointerId,
        what,
        offset: [handle[0] - point[0], handle[1] - point[1]],
        start: [event.clientX, event.clientY],
        moved: false,
        timer:
          coarse && what !== "moment"
            ? setTimeout(() => {
                finish(true);
                removeAt(what);
              }, LONG_PRESS_MS)
            : null,
      };
    },
    onPointerMove(event: PointerEvent) {
      const now = drag.current;
      if (now === null || event.pointerId !== now.pointer) return;
      if (!now.moved) {
        if (Math.hypot(event.clientX - now.start[0], event.clientY - now.start[1]) < SLACK) return;
        now.moved = true;
        if (now.timer !== null) clearTimeout(now.timer);
      }
      const { point } = toUv(event);
      const target: Uv = [point[0] + now.offset[0], point[1] + now.offset[1]];
      if (now.what === "moment") scrubTo(nearestOn(pathPoints.peek(), target).t);
      else moveTo(now.what, target, `way-drag-${now.what}`);
    },
    onPointerUp: (event: PointerEvent) => {
      if (event.pointerId === drag.current?.pointer) finish(false);
    },
    onPointerCancel: () => finish(true),
    onDblClick(event: MouseEvent) {
      event.preventDefault();
      const { point, perPixel } = toUv(event);
      const what = hit(point, perPixel * 12);
      if (typeof what === "number") removeAt(what);
      else addAt(point);
    },
  };
}
