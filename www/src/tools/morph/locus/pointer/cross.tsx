/** The keyboard's pointer on the field: a cross that arrow keys move, and that looks and picks as a hand does. */
import { signal } from "@preact/signals";
import { uv } from "#document/morph";
import { announce } from "#document/notice";
import type { Uv } from "#geometry/path";
import { pointOf } from "#geometry/polyline";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { isOutside } from "../path/handles";
import { addAt, place } from "../path/waypoints";
import { goHome, panBy, picked, pickPoint, shownWindow, view } from "../view/view";
import { zoomAbout } from "./gestures";
import { pointed } from "./hover";

export const CROSS_HINT = messages.arrowKeysMoveCross + messages.enterShowsShapeThere;

/** Parts of the window that a key moves the cross by. */
const STEP = 1 / 40;
const ZOOM = 1.5;

const cross = signal<Uv | null>(null);

function start(): Uv {
  const { u0, v0, u1, v1 } = shownWindow.peek();
  const { family, w } = view.peek();
  const at = picked.peek() ?? (family === "morph" ? uv.peek() : null);
  if (at && !isOutside(place(at, shownWindow.peek()))) return at;
  return pointOf((u0 + u1) / 2, (v0 + v1) / 2, w);
}

function move(to: Uv | null): void {
  cross.value = to;
  pointed.value = to && { at: to, by: "keys" };
}

/** What the plane does when focus comes by key, and when it goes. */
export function useCross() {
  return {
    onFocus(event: FocusEvent) {
      if (event.currentTarget instanceof Element && event.currentTarget.matches(":focus-visible"))
        move(start());
    },
    onBlur() {
      if (cross.peek()) move(null);
    },
    onPointerDown() {
      if (cross.peek()) move(null);
    },
  };
}

export function crossKey(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.target !== event.currentTarget) return;
  if (!act(event)) return;
  event.preventDefault();
  event.stopPropagation();
}

function act(event: KeyboardEvent): boolean {
  const at = cross.peek() ?? start();
  const step = STEP * (event.shiftKey ? 0.1 : event.altKey ? 5 : 1);
  switch (event.key) {
    case "ArrowRight":
      return go(at, step, 0);
    case "ArrowLeft":
      return go(at, -step, 0);
    case "ArrowUp":
      return go(at, 0, step);
    case "ArrowDown":
      return go(at, 0, -step);
    case "+":
    case "=":
      zoomAbout(ZOOM, at);
      break;
    case "-":
    case "_":
      zoomAbout(1 / ZOOM, at);
      break;
    case "0":
      goHome();
      break;
    case "Enter":
      pickPoint(at);
      announce(messages.pictureNowShowsThis);
      break;
    case "a":
    case "A":
    case "Insert":
      if (view.peek().family !== "morph") return false;
      addAt(at);
      break;
    case "Escape":
      if (!cross.peek()) return false;
      move(null);
      return true;
    default:
      return false;
  }
  move(at);
  return true;
}

/** The window follows where the cross would leave it. */
function go(at: Uv, x: number, y: number): true {
  const { u0, v0, u1, v1 } = shownWindow.peek();
  const w = view.peek().family === "morph" ? view.peek().w : 0;
  let next = pointOf(at[0] + x * (u1 - u0), at[1] + y * (v1 - v0), w);
  const [px, py] = place(next, shownWindow.peek());
  const over = (p: number) => (p < 0 ? p : p > 1 ? p - 1 : 0);
  if (over(px) !== 0 || over(py) !== 0) panBy(over(px), -over(py));
  const seen = shownWindow.peek();
  next = pointOf(
    Math.min(seen.u1, Math.max(seen.u0, next[0])),
    Math.min(seen.v1, Math.max(seen.v0, next[1])),
    w,
  );
  move(next);
  return true;
}

export function Cross() {
  const at = cross.value;
  if (!at) return null;
  const [x, y] = place(at, shownWindow.value);
  if (isOutside([x, y])) return null;
  return (
    <span
      class={fieldCss["locus-cross"]}
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      aria-hidden="true"
    />
  );
}
