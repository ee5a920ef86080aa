import { panned, type Screen, screen, zoomed } from "#geometry/coordinates";
import { effectiveView, fitView, stageSize, view } from "./view";
import { keepView } from "./view-link";

const WHEEL_REST_MS = 250;
const STEP = 1.25;
const KEY_PAN = 48;

/** Pan, pinch and wheel on one picture. Returns the end of it. */
export function attachGestures(element: HTMLElement): () => void {
  const down = new Map<number, Screen>();
  let rest: ReturnType<typeof setTimeout> | null = null;

  const at = (event: PointerEvent | WheelEvent | MouseEvent): Screen => {
    const box = element.getBoundingClientRect();
    return screen(event.clientX - box.left, event.clientY - box.top);
  };

  const pointerdown = (event: PointerEvent) => {
    if (event.button !== 0 || isHandle(event.target)) return;
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, at(event));
    element.dataset["dragging"] = "";
  };

  const pointermove = (event: PointerEvent) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const now = at(event);
    if (down.size === 1) {
      view.value = panned(effectiveView.peek(), now.x - before.x, now.y - before.y);
    } else if (down.size === 2) {
      const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? before;
      pinch(before, now, other);
    }
    down.set(event.pointerId, now);
  };

  const pointerup = (event: PointerEvent) => {
    if (!down.delete(event.pointerId)) return;
    if (down.size > 0) return;
    delete element.dataset["dragging"];
    keepView();
  };

  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    // A pinch on a touch pad arrives as a wheel with Ctrl held, in smaller steps.
    const factor = Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0016));
    zoomBy(factor, at(event));
    if (rest) clearTimeout(rest);
    rest = setTimeout(keepView, WHEEL_REST_MS);
  };

  const dblclick = (event: MouseEvent) => {
    if (isHandle(event.target)) return;
    fitStage();
  };

  element.addEventListener("pointerdown", pointerdown);
  element.addEventListener("pointermove", pointermove);
  element.addEventListener("pointerup", pointerup);
  element.addEventListener("pointercancel", pointerup);
  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("dblclick", dblclick);
  return () => {
    if (rest) clearTimeout(rest);
    element.removeEventListener("pointerdown", pointerdown);
    element.removeEventListener("pointermove", pointermove);
    element.removeEventListener("pointerup", pointerup);
    element.removeEventListener("pointercancel", pointerup);
    element.removeEventListener("wheel", wheel);
    element.removeEventListener("dblclick", dblclick);
  };
}

/** Two fingers: the point between them stays between them, their distance scales. */
function pinch(before: Screen, now: Screen, other: Screen): void {
  const length = (p: Screen) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
  const middle = (p: Screen) => screen((p.x + other.x) / 2, (p.y + other.y) / 2);
  const from = middle(before);
  const to = middle(now);
  const moved = panned(effectiveView.peek(), to.x - from.x, to.y - from.y);
  view.value = zoomed(moved, length(now) / length(before), to, stageSize.peek(), fitView.peek().scale);
}

function isHandle(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("[data-handle]") !== null;
}

export function zoomBy(factor: number, about?: Screen): void {
  const size = stageSize.peek();
  const point = about ?? screen(size.width / 2, size.height / 2);
  view.value = zoomed(effectiveView.peek(), factor, point, size, fitView.peek().scale);
}

export function fitStage(): void {
  view.value = null;
  keepView();
}

/** Keys on the focused stage. True when the key was one of them. */
export function stageKey(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const far = KEY_PAN * (event.shiftKey ? 0.25 : 1);
  const pans: Record<string, [number, number]> = {
    ArrowLeft: [far, 0],
    ArrowRight: [-far, 0],
    ArrowUp: [0, far],
    ArrowDown: [0, -far],
  };
  const pan = pans[event.key];
  if (pan) view.value = panned(effectiveView.peek(), ...pan);
  else if (event.key === "+" || event.key === "=") zoomBy(STEP);
  else if (event.key === "-" || event.key === "_") zoomBy(1 / STEP);
  else if (event.key === "0") {
    fitStage();
    return true;
  } else return false;
  keepView();
  return true;
}
