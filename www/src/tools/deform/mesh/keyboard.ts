/** What keys do on a handle. The mesh is one stop of Tab; within it keys go from handle to handle. */

import { announce } from "#document/notice";
import { type Mesh, type Point, sizeOf } from "#geometry/mesh";
import { latinKey } from "#ui/focus";
import { handleWords, nameOf } from "../deform-text";
import * as messages from "../messages";
import { nudge, resetChosen } from "./edit";
import { choose, chosen, clearChosen, lookAt, mesh, toggle } from "./mesh-state";

export const HINT =
  messages.rowsCountFromBottom +
  messages.withShiftByTenth +
  messages.bracketGoToNext +
  messages.deleteResetsSelectionEscape;

const ARROWS: Record<string, Point> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export const handleId = (index: number): string => `mesh-handle-${index}`;

export function focusHandle(index: number): void {
  lookAt(index);
  document.getElementById(handleId(index))?.focus({ preventScroll: true });
}

/** The neighbour in a direction, or the handle itself at the edge. */
export function neighbour({ columns, rows }: Pick<Mesh, "columns" | "rows">, index: number, [dx, dy]: Point) {
  const column = index % columns;
  const row = (index - column) / columns;
  const within = (x: number, count: number) => Math.min(count - 1, Math.max(0, x));
  return within(row + dy, rows) * columns + within(column + dx, columns);
}

/** A key on a handle. True when it was one of these. */
export function handleKey(index: number, event: KeyboardEvent): boolean {
  const now = mesh.peek();
  const count = now.columns * now.rows;
  const held = event.ctrlKey || event.metaKey;
  const arrow = ARROWS[event.key];
  if (arrow && held) {
    focusHandle(neighbour(now, index, arrow));
    return true;
  }
  if (held && latinKey(event).toLowerCase() === "a") {
    choose(Array.from({ length: count }, (_, i) => i));
    announce(messages.allSelected(count));
    return true;
  }
  if (held) return false;
  if (arrow) {
    const step = sizeOf(now.box) * (event.shiftKey ? 0.1 : event.altKey ? 0.001 : 0.01);
    if (chosen.peek().size === 0) choose([index], index);
    nudge(index, [arrow[0] * step, arrow[1] * step], `mesh keys ${index}`);
    announce(handleWords(mesh.peek(), index));
    return true;
  }
  switch (event.key) {
    case "]":
    case "PageDown":
      focusHandle((index + 1) % count);
      return true;
    case "[":
    case "PageUp":
      focusHandle((index + count - 1) % count);
      return true;
    case "Home":
      focusHandle(0);
      return true;
    case "End":
      focusHandle(count - 1);
      return true;
    case " ":
    case "Enter":
      toggle(index);
      announce(`${nameOf(now, index)}: ${chosen.peek().has(index) ? "chosen" : messages.deselected}.`);
      return true;
    case "Delete":
    case "Backspace":
      resetChosen();
      return true;
    case "Escape":
      if (chosen.peek().size === 0) return false;
      clearChosen();
      announce(messages.nothingSelected);
      return true;
    default:
      return false;
  }
}
