/** Keys of the keyboard that are about time, unless something is being typed or a dialog is open. */
import { type Focus, focusOf, type KeyPress } from "#ui/focus";
import type { ShortcutRow } from "#ui/ShortcutTable";
import { togglePlay } from "./clock";
import { goToKey, setKey } from "./keys";

export type TimeCommand = "play" | "key" | "before" | "after";

/** The command of a key press, or null where time has none. */
export function timeCommandOf(press: KeyPress, focus: Focus): TimeCommand | null {
  if (focus === "typing" || focus === "field" || press.ctrlKey || press.metaKey || press.altKey) return null;
  if (press.key === " ") return focus === "none" || focus === "slider" ? "play" : null;
  switch (press.key.toLowerCase()) {
    case "k":
      return "key";
    case ",":
      return "before";
    case ".":
      return "after";
    default:
      return null;
  }
}

function run(command: TimeCommand): void {
  if (command === "play") togglePlay();
  else if (command === "key") setKey();
  else goToKey(command === "before" ? -1 : 1);
}

/** Listens until the returned function is called. */
export function listenForTime(): () => void {
  const onKey = (event: KeyboardEvent) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
    const command = timeCommandOf(event, focusOf(event.target));
    if (command === null) return;
    event.preventDefault();
    run(command);
  };
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}

/** The visible list. */
export const TIME_SHORTCUTS: readonly { title: string; rows: readonly ShortcutRow[] }[] = [
  {
    title: "Time",
    rows: [
      { keys: [["Space"]], does: "Play, pause" },
      { keys: [["K"]], does: "Set a key" },
      { keys: [[","], ["."]], does: "To the key before, after" },
    ],
  },
  {
    title: "Key, in focus",
    rows: [
      { keys: [["←"], ["→"]], does: "Move it by 0.1 s; Shift finer, Alt farther" },
      { keys: [["Enter"]], does: "Go there" },
      { keys: [["Delete"]], does: "Delete it" },
    ],
  },
];
