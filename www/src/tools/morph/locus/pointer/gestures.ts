/** What pointers do on the square: they drag what lies on the path, move and enlarge the view, look, and pick. */
import { signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useRef } from "preact/hooks";
import { pathPoints, selection, uv } from "#document/morph";
import { endGesture } from "#document/scene";
import { screen } from "#geometry/coordinates";
import type { Uv } from "#geometry/path";
import { hitHandle, nearestOn, pointOf } from "#geometry/polyline";
import { CURRENT_ID, handleId } from "#stage/locus/WayPoints";
import { pinched, wheelFactor } from "#ui/panZoom";
import { scrubTo } from "../../edits";
import { addAt, moveTo, pick, removeAt, way } from "../path/waypoints";
import { zoomed } from "../view/geometry";
import { large } from "../view/large";
import { backToPath, panBy, pickPoint, setView, shownWindow, stopFlying, view, zoomBy } from "../view/view";
import { pointed } from "./hover";

/** A hand must travel this far, in CSS pixels, before it drags: a tap stays a tap. */
const DRAG_STARTS = 4;
/** Holding a finger still for so long looks at what is under it, or takes a waypoint away. */
const LONG_PRESS_MS = 500;
/** How near to the path a press counts as on it, in CSS pixels. */
const LINE_REACH = 7;
/** Two presses within this time are one that goes nearer, by so much. */
const DOUBLE_MS = 400;
const DOUBLE_ZOOM = 2.5;

type Place = readonly [x: number, y: number];

interface Drag {
  pointer: number;
  /** A waypoint by number, the place on the path, or the ground. */
  what: number | "moment" | "ground";
  /** From the handle to where it was taken hold of, so that it does not jump. */
  offset: readonly [number, number];
  start: Place;
  last: Place;
  moved: boolean;
  /** A finger that was held still: it looks around. */
  probing: boolean;
  timer: ReturnType<typeof setTimeout> | null;
}

/** Whether a wheel was turned over the map that was not pressed before: it is said what makes it zoom. */
export const wheelHint = signal(false);
let hintTimer: ReturnType<typeof setTimeout> | undefined;
const HINT_MS = 1600;

function hint(on: boolean): void {
  clearTimeout(hintTimer);
  wheelHint.value = on;
  if (on) hintTimer = setTimeout(() => hint(false), HINT_MS);
}

export function useGestures(square: RefObject<HTMLElement | null>) {
  const drag = useRef<Drag | null>(null);
  const tap = useRef<{ at: Place; time: number } | null>(null);
  const down = useRef(new Map<number, Place>());
  /** It was pressed, and the mouse has not left it since: the wheel is for the map, and not for the page around it. */
  const pressed = useRef(false);

  const boxOf = () => square.current?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1);
  /** Parts of the square from its left and from its bottom. */
  const partsOf = ([x, y]: Place): [number, number] => {
    const box = boxOf();
    return [(x - box.left) / (box.width || 1), 1 - (y - box.top) / (box.height || 1)];
  };
  const toUv = (place: Place): Uv => {
    const { u0, v0, u1, v1 } = shownWindow.peek();
    const [x, y] = partsOf(place);
    const { family, w } = view.peek();
    return pointOf(u0 + x * (u1 - u0), v0 + y * (v1 - v0), family === "morph" ? w : 0);
  };
  const perPixel = () => {
    const { u0, u1 } = shownWindow.peek();
    return (u1 - u0) / (boxOf().width || 1);
  };
  const placeOf = (event: MouseEvent): Place => [event.clientX, event.clientY];
  const isMorph = () => view.peek().family === "morph";

  /** The waypoint under a press, else the place on the path, else the ground. */
  const hit = (point: Uv, reach: number): Drag["what"] => {
    if (!isMorph()) return "ground";
    const points = way.peek();
    const index = hitHandle([...points, uv.peek()], point, reach);
    if (index < 0) return "ground";
    return index < points.length ? index : "moment";
  };
  const onLine = (point: Uv) => {
    if (!isMorph()) return null;
    const nearest = nearestOn(pathPoints.peek(), point);
    return nearest.distance < LINE_REACH * perPixel() ? nearest : null;
  };
  const finish = (cancel: boolean) => {
    const done = drag.current;
    if (done === null) return;
    if (done.timer !== null) clearTimeout(done.timer);
    drag.current = null;
    if (done.what !== "ground" && (cancel || done.moved)) endGesture();
    if (done.probing) pointed.value = null;
  };
  const pinch = (event: PointerEvent, before: Place) => {
    const other = [...down.current].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) return;
    const moved = pinched(screen(...before), screen(...placeOf(event)), screen(...other), 8);
    const [from, to] = [partsOf([moved.from.x, moved.from.y]), partsOf([moved.to.x, moved.to.y])];
    panBy(from[0] - to[0], from[1] - to[1]);
    zoomBy(moved.factor, to);
  };

  return {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0) return;
      pressed.current = true;
      hint(false);
      if (event.target instanceof Element && event.target.closest("button")) return;
      const place = placeOf(event);
      down.current.set(event.pointerId, place);
      if (down.current.size > 1) {
        // A second finger: it was no drag, it is a pinch.
        finish(true);
        square.current?.setPointerCapture(event.pointerId);
        return;
      }
      stopFlying();
      const point = toUv(place);
      const coarse = event.pointerType !== "mouse";
      const what = hit(point, perPixel() * (coarse ? 24 : 12));
      const handle =
        what === "moment" ? uv.peek() : typeof what === "number" ? (way.peek()[what] ?? point) : point;
      const held: Drag = {
        pointer: event.pointerId,
        what,
        offset: [handle[0] - point[0], handle[1] - point[1]],
        start: place,
        last: place,
        moved: false,
        probing: false,
        timer: null,
      };
      if (coarse && what !== "moment") held.timer = setTimeout(() => hold(held), LONG_PRESS_MS);
      drag.current = held;
      if (what === "ground") {
        pick(null);
        if (coarse && view.peek().zoom > 1) square.current?.setPointerCapture(event.pointerId);
      } else {
        event.preventDefault();
        pointed.value = null;
        document
          .getElementById(what === "moment" ? CURRENT_ID : handleId(what))
          ?.focus({ preventScroll: true });
        square.current?.setPointerCapture(event.pointerId);
      }
    },
    onPointerMove(event: PointerEvent) {
      const place = placeOf(event);
      const before = down.current.get(event.pointerId);
      if (before && down.current.size > 1) {
        pinch(event, before);
        down.current.set(event.pointerId, place);
        return;
      }
      if (before) down.current.set(event.pointerId, place);
      const now = drag.current;
      if (now === null) {
        if (event.pointerType !== "mouse" || event.buttons !== 0) return;
        // Who is at a button looks at nothing below it.
        if (event.target instanceof Element && event.target.closest("button")) unhover();
        else hover(place);
        return;
      }
      if (event.pointerId !== now.pointer) return;
      if (now.probing) {
        pointed.value = { at: toUv(place), by: "touch" };
        return;
      }
      if (!now.moved) {
        if (Math.hypot(place[0] - now.start[0], place[1] - now.start[1]) < DRAG_STARTS) return;
        now.moved = true;
        if (now.timer !== null) clearTimeout(now.timer);
        if (now.what === "ground") {
          pointed.value = null;
          square.current?.setPointerCapture(event.pointerId);
        }
      }
      if (now.what === "ground") {
        const [from, to] = [partsOf(now.last), partsOf(place)];
        if (view.peek().zoom > 1) panBy(from[0] - to[0], from[1] - to[1]);
        now.last = place;
        return;
      }
      const point = toUv(place);
      const target: Uv = [point[0] + now.offset[0], point[1] + now.offset[1]];
      if (now.what === "moment") scrubTo(nearestOn(pathPoints.peek(), target).t);
      else {
        const [, , w = 0] = way.peek()[now.what] ?? point;
        moveTo(now.what, pointOf(target[0], target[1], w), `way-drag-${now.what}`);
      }
    },
    onPointerUp(event: PointerEvent) {
      down.current.delete(event.pointerId);
      const now = drag.current;
      if (now?.pointer !== event.pointerId) return;
      const tapped = !now.moved && !now.probing;
      finish(false);
      if (tapped) press(placeOf(event), now.what, event);
    },
    onPointerCancel(event: PointerEvent) {
      down.current.delete(event.pointerId);
      finish(true);
    },
    onPointerLeave(event: PointerEvent) {
      pressed.current = false;
      if (event.pointerType === "mouse" && drag.current === null) unhover();
    },
    // Two presses are told apart from one above, for fingers too; the browser is to select nothing.
    onDblClick: (event: MouseEvent) => event.preventDefault(),
    onWheel(event: WheelEvent) {
      if (!(pressed.current || large.peek() || event.ctrlKey || event.metaKey)) return hint(true);
      // At home there is no farther: the panel scrolls.
      if (view.peek().zoom === 1 && event.deltaY > 0 && !event.ctrlKey) return;
      event.preventDefault();
      zoomBy(wheelFactor(event, 0.0022), partsOf(placeOf(event)));
      if (pointed.peek()?.by === "mouse") pointed.value = null;
    },
    // At home one finger scrolls the sheet; two, or one that looks around, must not.
    onTouchStart(event: TouchEvent) {
      if (event.touches.length > 1 && event.cancelable) event.preventDefault();
    },
    onTouchMove(event: TouchEvent) {
      if ((event.touches.length > 1 || drag.current?.probing) && event.cancelable) event.preventDefault();
    },
    onContextMenu(event: MouseEvent) {
      // What a long press brings up on a phone.
      if (drag.current !== null || pointed.peek()?.by === "touch") event.preventDefault();
    },
  };

  function hold(held: Drag): void {
    if (drag.current !== held) return;
    held.timer = null;
    if (typeof held.what === "number") {
      const index = held.what;
      finish(true);
      removeAt(index);
    } else if (held.what === "ground") {
      held.probing = true;
      square.current?.setPointerCapture(held.pointer);
      pointed.value = { at: toUv(held.start), by: "touch" };
    }
  }

  function hover(place: Place): void {
    const point = toUv(place);
    const busy = hit(point, perPixel() * 12) !== "ground";
    pointed.value = busy ? null : { at: point, by: "mouse" };
  }

  function unhover(): void {
    if (pointed.peek()?.by === "mouse") pointed.value = null;
  }

  /**
   * A press on the path goes there; elsewhere it takes the point. The second of two takes a waypoint away, adds one on
   * the path, and goes nearer anywhere else.
   */
  function press(at: Place, what: Drag["what"], { timeStamp: time, pointerType }: PointerEvent): void {
    const last = tap.current;
    const near = pointerType === "mouse" ? DRAG_STARTS : 24;
    const twice =
      last && time - last.time < DOUBLE_MS && Math.hypot(at[0] - last.at[0], at[1] - last.at[1]) < near;
    tap.current = twice ? null : { at, time };
    const point = toUv(at);
    const line = what === "ground" ? onLine(point) : null;
    if (typeof what === "number") {
      if (twice) removeAt(what);
    } else if (twice && (line || what === "moment")) addAt(line?.at ?? uv.peek());
    else if (twice) zoomBy(DOUBLE_ZOOM, partsOf(at));
    else if (line) {
      if (view.peek().at) backToPath();
      scrubTo(line.t);
    } else if (what === "ground") {
      pickPoint(point);
      // Whoever points at a shape wants to see it, not the one that is being edited.
      selection.value = null;
    }
  }
}

/** Enlarges about a parameter, which stays where it is. */
export function zoomAbout(factor: number, [u, v]: Uv): void {
  const { u0, v0, u1, v1 } = shownWindow.peek();
  const { x, y, zoom } = zoomed(view.peek(), factor, [(u - u0) / (u1 - u0), (v - v0) / (v1 - v0)]);
  setView({ x, y, zoom });
}
