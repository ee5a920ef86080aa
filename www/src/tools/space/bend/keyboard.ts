/** What keys do on a handle of the lattice. It is one stop of Tab; within it keys go from handle to handle. */
import { bend, changeBend, handles, pull, push, take, tell } from "./now";

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
/** Pixels of an arrow key, and the part of the box that a key moves away. */
const STEP = 4;
const PART = 0.01;

export const handleId = (index: number): string => `bend-handle-${index}`;

/** True when the key was one of a handle's. */
export function handleKey(index: number, event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const by = event.shiftKey ? 10 : 1;
  const arrow = ARROWS[event.key];
  const gesture = `bend-keys-${index}`;
  if (arrow) {
    pull(index, arrow[0] * STEP * by, arrow[1] * STEP * by, gesture);
    tell(index);
    return true;
  }
  switch (event.key) {
    case "PageUp":
    case "PageDown":
      push(index, (event.key === "PageUp" ? PART : -PART) * by, gesture);
      tell(index);
      return true;
    case "[":
      go(index - 1);
      return true;
    case "]":
      go(index + 1);
      return true;
    case "Delete":
    case "Backspace":
      changeBend((now) => ({ ...now, moves: now.moves.map((old, i) => (i === index ? [0, 0, 0] : old)) }));
      tell(index);
      return true;
    default:
      return false;
  }
}

/** To another handle, round at the ends; those behind the eye are passed over. */
function go(index: number): void {
  const count = bend.peek()?.moves.length ?? 0;
  const step = handles.peek()[(index + count) % count] ? (index + count) % count : null;
  if (step === null) return;
  take(step);
  document.getElementById(handleId(step))?.focus({ preventScroll: true });
}
