/** Pan, pinch, wheel and brush on the stage of the fit. */
import { type Screen, screen } from "#geometry/coordinates";
import { frame } from "../work/outline";
import { opened } from "../work/source";
import { beginStroke, cursor, dropStroke, endStroke, goOn, painting } from "./brush";
import { fitStage, panBy, under, zoomBy } from "./camera";

/** The pixel of the picture under a point of the stage. */
export function pixelUnder(at: Screen): { x: number; y: number } {
  const { x, y } = under(at);
  const { scale, x: fx, y: fy } = frame.peek();
  const height = opened.peek()?.height ?? 0;
  return { x: x / scale + fx, y: height - (y / scale + fy) };
}

/** Returns the end of it. */
export function attachGestures(element: HTMLElement): () => void {
  const end = new AbortController();
  const { signal } = end;
  const down = new Map<number, Screen>();

  const at = (event: PointerEvent | WheelEvent): Screen => {
    const box = element.getBoundingClientRect();
    return screen(event.clientX - box.left, event.clientY - box.top);
  };

  element.addEventListener(
    "pointerdown",
    (event) => {
      // The middle button moves the picture, whatever is in hand.
      if (event.button > 1 || (event.target as Element).closest("button")) return;
      if (event.button === 1) event.preventDefault();
      element.setPointerCapture(event.pointerId);
      down.set(event.pointerId, at(event));
      if (down.size === 1 && painting.peek() && event.button === 0) {
        const place = pixelUnder(at(event));
        cursor.value = place;
        beginStroke(place);
      } else {
        // A second finger comes to enlarge: what the first began is no stroke.
        dropStroke();
        element.dataset["dragging"] = "";
      }
    },
    { signal },
  );
  element.addEventListener(
    "pointermove",
    (event) => {
      const now = at(event);
      if (painting.peek()) cursor.value = pixelUnder(now);
      const before = down.get(event.pointerId);
      if (!before) return;
      if (down.size === 1) {
        if (element.dataset["dragging"] === undefined) {
          const all = event.getCoalescedEvents?.() ?? [];
          for (const one of all.length > 0 ? all : [event]) goOn(pixelUnder(at(one)));
        } else panBy(now.x - before.x, now.y - before.y);
      } else if (down.size === 2) {
        const other = [...down].find(([id]) => id !== event.pointerId)?.[1] ?? before;
        pinch(before, now, other);
      }
      down.set(event.pointerId, now);
    },
    { signal },
  );
  const up = (event: PointerEvent) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    delete element.dataset["dragging"];
    if (event.type === "pointerup") endStroke();
    else dropStroke();
  };
  element.addEventListener("pointerup", up, { signal });
  element.addEventListener("pointercancel", up, { signal });
  element.addEventListener(
    "pointerleave",
    () => {
      if (down.size === 0 && document.activeElement !== element) cursor.value = null;
    },
    { signal },
  );
  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
      zoomBy(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0016)), at(event));
    },
    { signal, passive: false },
  );
  element.addEventListener(
    "dblclick",
    (event) => {
      if (!painting.peek() && !(event.target as Element).closest("button")) fitStage();
    },
    { signal },
  );
  return () => {
    end.abort();
    dropStroke();
  };
}

/** Two fingers: the point between them stays between them, their distance scales. */
function pinch(before: Screen, now: Screen, other: Screen): void {
  const length = (p: Screen) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
  const middle = (p: Screen) => screen((p.x + other.x) / 2, (p.y + other.y) / 2);
  const [from, to] = [middle(before), middle(now)];
  panBy(to.x - from.x, to.y - from.y);
  zoomBy(length(now) / length(before), to);
}

const KEY_PAN = 48;
const STEP = 1.25;

/** Keys on the focused stage while nothing is painted. True when the key was one of them. */
export function stageKey(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const far = KEY_PAN * (event.shiftKey ? 0.25 : 1);
  switch (event.key) {
    case "ArrowLeft":
      panBy(far, 0);
      break;
    case "ArrowRight":
      panBy(-far, 0);
      break;
    case "ArrowUp":
      panBy(0, far);
      break;
    case "ArrowDown":
      panBy(0, -far);
      break;
    case "+":
    case "=":
      zoomBy(STEP);
      break;
    case "-":
    case "_":
      zoomBy(1 / STEP);
      break;
    case "0":
      fitStage();
      break;
    default:
      return false;
  }
  return true;
}
