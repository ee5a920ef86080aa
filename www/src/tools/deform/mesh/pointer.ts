/**
 * What pointers do on the mesh. It listens before the picture does and takes what is meant for handles; everything else
 * goes on to the picture, which is moved and enlarged as ever. A second finger always means the picture.
 */
import { signal } from "@preact/signals";
import { phasePlaying } from "#document/deform/bend";
import { announce } from "#document/notice";
import { endGesture, undo } from "#document/scene";
import { placeAt } from "#geometry/bezier";
import { type Screen, screen } from "#geometry/coordinates";
import type { Point } from "#geometry/mesh";
import { effectiveView } from "#stage/view";
import { handleWords } from "../deform-text";
import * as messages from "../messages";
import { pulled, shifted } from "./edit";
import { crossingAt, handlesOf, inPlane, inside, nearest, onPlane } from "./hit";
import { focusHandle } from "./keyboard";
import { choose, chosen, clearChosen, gridShown, hand, mesh, setMoves, toggle } from "./mesh-state";

/** How near a press must be, in CSS pixels: half of what a finger needs, and less where a pointer is fine. */
const REACH = { finger: 22, mouse: 14, crossing: 7 };
/** A hand must travel this far before it drags: a tap stays a tap. */
const DRAG_STARTS = { finger: 6, mouse: 3 };

type Aim =
  | { kind: "handle"; index: number }
  /** A place of the box that is pulled along. */
  | { kind: "pull"; place: Point }
  | { kind: "frame" };

interface Drag {
  pointer: number;
  aim: Aim;
  start: Screen;
  last: Screen;
  moved: boolean;
  finger: boolean;
  /** The moves when it began. */
  before: readonly number[];
  /** What was chosen when it began. */
  had: ReadonlySet<number>;
  /** What is to come of it when it turns out a tap: the handle is chosen alone, or let go. */
  tap: "nothing" | "alone" | "drop";
}

/** The rectangle that chooses what lies in it, while it is drawn. */
export const frame = signal<readonly [Screen, Screen] | null>(null);
/** What a press here would take hold of: a handle by number, or a crossing of the grid. */
export const under = signal<number | Screen | null>(null);
/** Where the mesh is pulled, while it is. */
export const grip = signal<Point | null>(null);

const MODIFIERS: ReadonlySet<string> = new Set(["Shift", "Control", "Alt", "Meta"]);
const GESTURE = "mesh drag";

/** Listens on the part of the stage that holds the picture. `root` keeps the pointers that it has taken. */
export function attachPointer(pane: HTMLElement, root: HTMLElement): () => void {
  let drag: Drag | null = null;
  /** A press that the picture has: where it began. */
  const passing = new Map<number, Screen>();

  const at = (event: MouseEvent): Screen => {
    const box = root.getBoundingClientRect();
    return screen(event.clientX - box.left, event.clientY - box.top);
  };

  /** What a press would take hold of. While it only looks, the place of a pull is not worked out. */
  const aimOf = (event: PointerEvent, looking = false): Aim | null => {
    const point = at(event);
    const finger = event.pointerType !== "mouse";
    const now = mesh.peek();
    const pull = (place: Point): Aim => ({ kind: "pull", place });
    const here = (): Point => (looking ? [0, 0] : placeAt(now, onPlane(point)));
    if (event.altKey) return pull(here());
    const index = nearest(handlesOf(now), point, finger ? REACH.finger : REACH.mouse);
    if (index >= 0) return { kind: "handle", index };
    if (event.shiftKey || hand.peek() === "choose") return { kind: "frame" };
    if (hand.peek() === "pull") return pull(here());
    // Fingers are wider than the room between crossings: they have the mode.
    const crossing = finger ? null : crossingAt(now, point, REACH.crossing);
    return crossing && pull(crossing.place);
  };

  const down = (event: PointerEvent) => {
    if (event.button !== 0 || !gridShown.peek() || !onPicture(event)) return;
    if (drag) {
      // A second finger: both are the picture's now.
      handOver();
      passing.set(event.pointerId, at(event));
      return;
    }
    const aim = passing.size > 0 ? null : aimOf(event);
    if (!aim) {
      passing.set(event.pointerId, at(event));
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    root.setPointerCapture(event.pointerId);
    phasePlaying.value = false;
    // The ring tells where keys go: it comes with the first of them.
    root.dataset["hand"] = "";
    const start = at(event);
    const had = chosen.peek();
    const finger = event.pointerType !== "mouse";
    drag = {
      pointer: event.pointerId,
      aim,
      start,
      last: start,
      moved: false,
      finger,
      before: mesh.peek().moves,
      had,
      tap: "nothing",
    };
    if (aim.kind === "handle") drag.tap = take(aim.index, event);
    under.value = null;
  };

  const move = (event: PointerEvent) => {
    if (!drag) {
      look(event);
      return;
    }
    if (event.pointerId !== drag.pointer) return;
    const now = at(event);
    const slack = drag.finger ? DRAG_STARTS.finger : DRAG_STARTS.mouse;
    if (!drag.moved && Math.hypot(now.x - drag.start.x, now.y - drag.start.y) < slack) return;
    drag.last = now;
    drag.moved = true;
    follow(drag);
  };

  const up = (event: PointerEvent) => {
    const from = passing.get(event.pointerId);
    if (from) {
      passing.delete(event.pointerId);
      const { x, y } = at(event);
      const still = Math.hypot(x - from.x, y - from.y) < DRAG_STARTS.mouse;
      if (still && event.type === "pointerup" && !event.shiftKey) clearChosen();
    }
    if (event.pointerId !== drag?.pointer) return;
    if (event.type === "pointercancel") cancel();
    else finish(drag);
  };

  const finish = ({ aim, moved, tap }: Drag) => {
    rest();
    if (aim.kind === "handle" && moved) announce(handleWords(mesh.peek(), aim.index));
    else if (aim.kind === "handle" && tap === "alone") choose([aim.index], aim.index);
    else if (aim.kind === "handle" && tap === "drop") toggle(aim.index);
    else if (aim.kind === "frame") {
      if (!moved) clearChosen();
      const [first] = chosen.peek();
      if (moved && first !== undefined) focusHandle(first);
      announce(
        chosen.peek().size === 0 ? messages.nothingSelected : messages.handlesSelected(chosen.peek().size),
      );
    }
  };

  /** Nothing is held any more. */
  const rest = () => {
    if (drag?.moved) endGesture();
    drag = null;
    frame.value = null;
    grip.value = null;
  };

  /** As if it had not been taken hold of. */
  const cancel = () => {
    if (!drag) return;
    const { moved, aim, had } = drag;
    const changed = moved && mesh.peek().moves.some((x, i) => x !== drag?.before[i]);
    rest();
    if (changed && aim.kind !== "frame") undo();
    choose(had);
  };

  const handOver = () => {
    if (!drag) return;
    const { pointer, last } = drag;
    cancel();
    const box = root.getBoundingClientRect();
    const init = {
      pointerId: pointer,
      pointerType: "touch",
      isPrimary: true,
      clientX: box.left + last.x,
      clientY: box.top + last.y,
    };
    passing.set(pointer, last);
    pane.querySelector(".picture")?.dispatchEvent(new PointerEvent("pointerdown", init));
  };

  const look = (event: PointerEvent) => {
    if (event.pointerType !== "mouse" || event.buttons !== 0 || !gridShown.peek() || !onPicture(event)) {
      if (under.peek() !== null) under.value = null;
      delete pane.dataset["mesh"];
      return;
    }
    const aim = aimOf(event, true);
    if (aim) pane.dataset["mesh"] = aim.kind;
    else delete pane.dataset["mesh"];
    if (aim?.kind === "handle") under.value = aim.index;
    else under.value = aim?.kind === "pull" ? at(event) : null;
  };

  const leave = () => {
    under.value = null;
    delete pane.dataset["mesh"];
  };

  const double = (event: MouseEvent) => {
    // Two presses on a handle do not fit the picture to the stage.
    if (nearest(handlesOf(mesh.peek()), at(event), REACH.mouse) >= 0 && gridShown.peek())
      event.stopPropagation();
  };

  const key = (event: KeyboardEvent) => {
    if (!MODIFIERS.has(event.key)) delete root.dataset["hand"];
    if (event.key !== "Escape" || !drag) return;
    event.preventDefault();
    event.stopPropagation();
    cancel();
  };

  const listeners = [
    ["pointerdown", down],
    ["pointermove", move],
    ["pointerup", up],
    ["pointercancel", up],
    ["pointerleave", leave],
    ["dblclick", double],
  ] as [string, (event: Event) => void][];
  for (const [name, listener] of listeners)
    pane.addEventListener(name, listener, { capture: name !== "pointerleave" });
  document.addEventListener("keydown", key, { capture: true });
  return () => {
    cancel();
    leave();
    for (const [name, listener] of listeners)
      pane.removeEventListener(name, listener, { capture: name !== "pointerleave" });
    document.removeEventListener("keydown", key, { capture: true });
  };
}

/** A press takes hold of a handle: it is chosen at once, and what is let go is let go by a tap, not by a drag. */
function take(index: number, event: PointerEvent): Drag["tap"] {
  const many = event.shiftKey || event.ctrlKey || event.metaKey || hand.peek() === "choose";
  const was = chosen.peek().has(index);
  if (!was) choose(many ? [...chosen.peek(), index] : [index], index);
  focusKeeping(index);
  return was ? (many ? "drop" : "alone") : "nothing";
}

/** The keys go on where the pointer was, and the choice stays as it is. */
function focusKeeping(index: number): void {
  const all = [...chosen.peek()];
  focusHandle(index);
  choose(all, index);
}

function follow(drag: Drag): void {
  const by = inPlane(drag.start, drag.last, effectiveView.peek());
  switch (drag.aim.kind) {
    case "frame":
      frame.value = [drag.start, drag.last];
      choose([...drag.had, ...inside(handlesOf(mesh.peek()), drag.start, drag.last)]);
      return;
    case "pull":
      grip.value = drag.aim.place;
      setMoves(pulled(drag.before, drag.aim.place, by), GESTURE);
      return;
    case "handle": {
      const { index } = drag.aim;
      const all = chosen.peek();
      setMoves(shifted(drag.before, all.has(index) ? all : [index], index, by), GESTURE);
    }
  }
}

function onPicture(event: Event): boolean {
  return event.target instanceof Element && event.target.closest(".picture") !== null;
}
