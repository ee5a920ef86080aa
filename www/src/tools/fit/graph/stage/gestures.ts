/** Mouse, finger, wheel and keys on the stage: along t. */

import { panBy, showAll, span, zoomAbout } from "../model/span";
import { leftOf, tAt } from "./frame";
import { frame } from "./shown";

const STEP = 1.25;
const PAN = 0.06;

/** Pan, pinch and wheel. Returns the end of it. `onTap`: a press that moved nothing. */
export function attachGestures(element: HTMLElement, onTap: (left: number, top: number) => void): () => void {
  const down = new Map<number, number>();
  let far = 0;

  const at = (event: MouseEvent): [number, number] => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const onHandle = (event: Event) =>
    event.target instanceof Element && event.target.closest("[data-handle]") !== null;

  const pointerdown = (event: PointerEvent) => {
    if (event.button !== 0 || onHandle(event)) return;
    element.setPointerCapture(event.pointerId);
    if (down.size === 0) far = 0;
    down.set(event.pointerId, at(event)[0]);
    element.dataset["dragging"] = "";
  };
  const pointermove = (event: PointerEvent) => {
    const before = down.get(event.pointerId);
    if (before === undefined) return;
    const [now] = at(event);
    far += Math.abs(now - before);
    const width = frame.peek().width;
    if (down.size === 1) {
      // A tap that trembles is a tap.
      if (far > 4) panBy((before - now) / width);
    } else {
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? before;
      const gap = (x: number) => Math.max(12, Math.abs(x - other));
      const middle = tAt(frame.peek(), (before + other) / 2);
      zoomAbout(gap(now) / gap(before), middle);
      panBy((before - now) / 2 / width);
    }
    down.set(event.pointerId, now);
  };
  const pointerup = (event: PointerEvent) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    delete element.dataset["dragging"];
    if (far <= 4 && event.type === "pointerup") onTap(...at(event));
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const scale = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
    // Sideways on a touch pad moves; up and down zooms, and so does a pinch, in smaller steps.
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY) && !event.ctrlKey) {
      panBy((event.deltaX * scale) / frame.peek().width);
      return;
    }
    const factor = Math.exp(-event.deltaY * scale * (event.ctrlKey ? 0.01 : 0.0016));
    zoomAbout(factor, tAt(frame.peek(), at(event)[0]));
  };
  const dblclick = (event: MouseEvent) => {
    if (!onHandle(event)) showAll();
  };

  element.addEventListener("pointerdown", pointerdown);
  element.addEventListener("pointermove", pointermove);
  element.addEventListener("pointerup", pointerup);
  element.addEventListener("pointercancel", pointerup);
  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("dblclick", dblclick);
  return () => {
    element.removeEventListener("pointerdown", pointerdown);
    element.removeEventListener("pointermove", pointermove);
    element.removeEventListener("pointerup", pointerup);
    element.removeEventListener("pointercancel", pointerup);
    element.removeEventListener("wheel", wheel);
    element.removeEventListener("dblclick", dblclick);
  };
}

/** Keys on the focused stage. True when the key was one of them. */
export function stageKey(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const far = PAN * (event.shiftKey ? 0.25 : 1);
  if (event.key === "ArrowLeft") panBy(-far);
  else if (event.key === "ArrowRight") panBy(far);
  else if (event.key === "+" || event.key === "=") zoomAbout(STEP);
  else if (event.key === "-" || event.key === "_") zoomAbout(1 / STEP);
  else if (event.key === "0") showAll();
  else return false;
  return true;
}

/** Whether t lies on the stage. */
export function isShown(t: number): boolean {
  const [from, to] = span.value;
  return t >= from && t <= to && Number.isFinite(leftOf(frame.value, t));
}
