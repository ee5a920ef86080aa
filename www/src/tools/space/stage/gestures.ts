import { endGesture } from "#document/scene";
import { choose, hand } from "#document/space/space";
import { changeView, handObject, showWhole } from "./actions";
import { neared, panned, turnedByHand } from "./camera";
import { sight } from "./sight";
import { objectUnder, stageSize } from "./state";

interface Point {
  x: number;
  y: number;
}

type Doing = "look" | "pan" | "turn" | "move" | "scale";

let gestures = 0;

/** Drags, pinches and the wheel on the stage of space. Returns the end of it. */
export function attachGestures(element: HTMLElement): () => void {
  const down = new Map<number, Point>();
  let doing: Doing = "look";
  let gesture = "";
  /** What has not been shown yet: there are more events than frames. */
  let due: { dx: number; dy: number; factor: number } | null = null;
  let frame = 0;

  const at = (event: PointerEvent): Point => ({ x: event.clientX, y: event.clientY });
  const height = () => stageSize.peek().height;

  const act = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    if (!due) return;
    const { dx, dy, factor } = due;
    due = null;
    if (factor !== 1) changeView((view) => neared(view, factor, sight.peek()?.ball ?? null));
    if (dx === 0 && dy === 0) return;
    if (doing === "look") changeView((view) => turnedByHand(view, dx, dy, height()));
    else if (doing === "pan") changeView((view) => panned(view, dx, dy, height()));
    else handObject(doing, dx, dy, gesture);
  };
  const later = (dx: number, dy: number, factor = 1) => {
    const before = due ?? { dx: 0, dy: 0, factor: 1 };
    due = { dx: before.dx + dx, dy: before.dy + dy, factor: before.factor * factor };
    if (!frame) frame = requestAnimationFrame(act);
  };
  const end = () => {
    act();
    if (doing !== "look" && doing !== "pan") endGesture();
  };

  // What a hand is laid on is what it turns; beside everything, what was chosen before.
  const takeHold = (event: PointerEvent) => {
    const box = element.getBoundingClientRect();
    const under = objectUnder(event.clientX - box.left, event.clientY - box.top);
    if (under !== null) choose(under);
  };

  const pointerdown = (event: PointerEvent) => {
    if (event.button > 2) return;
    element.setPointerCapture(event.pointerId);
    if (down.size === 0) {
      doing = event.button !== 0 || event.shiftKey ? "pan" : hand.peek();
      gesture = `space-hand-${++gestures}`;
      if (doing !== "look" && doing !== "pan") takeHold(event);
    } else {
      // A second finger is for the view, whatever the first one did.
      end();
      doing = "pan";
    }
    down.set(event.pointerId, at(event));
    element.dataset["dragging"] = "";
  };

  const pointermove = (event: PointerEvent) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const now = at(event);
    down.set(event.pointerId, now);
    if (down.size === 1) {
      later(now.x - before.x, now.y - before.y);
      return;
    }
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? before;
    const apart = (p: Point) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    // The point between two fingers goes half as far as one of them.
    later((now.x - before.x) / 2, (now.y - before.y) / 2, apart(now) / apart(before));
  };

  const pointerup = (event: PointerEvent) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    end();
    delete element.dataset["dragging"];
  };

  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    // A pinch on a touch pad arrives as a wheel with Ctrl held, in smaller steps.
    later(0, 0, Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0016)));
  };

  const dblclick = () => showWhole();
  // The right button shifts, and the middle one does not scroll.
  const contextmenu = (event: Event) => event.preventDefault();
  const mousedown = (event: MouseEvent) => {
    if (event.button === 1) event.preventDefault();
  };

  element.addEventListener("pointerdown", pointerdown);
  element.addEventListener("pointermove", pointermove);
  element.addEventListener("pointerup", pointerup);
  element.addEventListener("pointercancel", pointerup);
  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("dblclick", dblclick);
  element.addEventListener("contextmenu", contextmenu);
  element.addEventListener("mousedown", mousedown);
  return () => {
    if (down.size > 0) end();
    cancelAnimationFrame(frame);
    element.removeEventListener("pointerdown", pointerdown);
    element.removeEventListener("pointermove", pointermove);
    element.removeEventListener("pointerup", pointerup);
    element.removeEventListener("pointercancel", pointerup);
    element.removeEventListener("wheel", wheel);
    element.removeEventListener("dblclick", dblclick);
    element.removeEventListener("contextmenu", contextmenu);
    element.removeEventListener("mousedown", mousedown);
  };
}
