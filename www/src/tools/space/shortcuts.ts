/** Keys that work anywhere while space is open, unless something is being typed or a dialog is open. */

import { redo, undo } from "#document/scene";
import { hand } from "#document/space/space";
import { type Focus, focusOf, type KeyPress } from "#ui/focus";
import { help } from "#ui/help";
import type { ShortcutRow } from "#ui/ShortcutTable";
import { goToOrigin, showWhole } from "./stage/actions";
import { TIME_SHORTCUTS } from "./time/shortcuts";

type Hand = typeof hand.value;

export type Command = { do: "undo" | "redo" | "whole" | "origin" | "help" } | { do: "hand"; by: Hand };

const HANDS: Record<string, Hand> = { "1": "look", "2": "turn", "3": "move", "4": "scale" };

/** The command of a key press, or null where the tool has none. The time line has its own. */
export function commandOf(press: KeyPress, focus: Focus): Command | null {
  const { key, shiftKey, altKey } = press;
  if (focus === "typing") return null;
  if (press.ctrlKey || press.metaKey) {
    if (altKey) return null;
    if (key.toLowerCase() === "z") return { do: shiftKey ? "redo" : "undo" };
    return key.toLowerCase() === "y" ? { do: "redo" } : null;
  }
  if (altKey || focus === "field") return null;
  const by = HANDS[key];
  if (by !== undefined) return { do: "hand", by };
  switch (key.toLowerCase()) {
    case "z":
      return { do: shiftKey ? "redo" : "undo" };
    case "0":
    case "f":
      return { do: "whole" };
    case "o":
      return { do: "origin" };
    case "?":
      return { do: "help" };
    default:
      return null;
  }
}

function run(command: Command): void {
  switch (command.do) {
    case "undo":
      undo();
      break;
    case "redo":
      redo();
      break;
    case "whole":
      showWhole();
      break;
    case "origin":
      goToOrigin();
      break;
    case "help":
      help.value = true;
      break;
    case "hand":
      hand.value = command.by;
      break;
  }
}

/** Listens until the returned function is called. */
export function listen(): () => void {
  const onKey = (event: KeyboardEvent) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
    const command = commandOf(event, focusOf(event.target));
    if (command === null) return;
    event.preventDefault();
    run(command);
  };
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}

/** The visible list. */
export const SHORTCUTS: readonly { title: string; rows: readonly ShortcutRow[] }[] = [
  {
    title: "What a drag does",
    rows: [
      { keys: [["1"]], does: "Look around" },
      { keys: [["2"], ["3"], ["4"]], does: "Turn, move, scale the object" },
      { keys: [["Shift"]], does: "Held while dragging: shift what is seen" },
    ],
  },
  {
    title: "Where the picture has the focus",
    rows: [
      { keys: [["←"], ["→"], ["↑"], ["↓"]], does: "What a drag does; with Shift, shift what is seen" },
      { keys: [["+"], ["−"]], does: "Nearer, farther" },
      { keys: [["W"], ["A"], ["S"], ["D"]], does: "Fly ahead, left, back, right; Shift finer" },
      { keys: [["Q"], ["E"]], does: "Fly down, up" },
      { keys: [["["], ["]"]], does: "A smaller angle of view, a larger one" },
    ],
  },
  {
    title: "Places to look from",
    rows: [
      { keys: [["0"], ["F"]], does: "All of it" },
      { keys: [["O"]], does: "From the origin" },
    ],
  },
  ...TIME_SHORTCUTS,
  {
    title: "Everywhere",
    rows: [
      { keys: [["Z"], ["Ctrl", "Z"]], does: "Undo" },
      {
        keys: [
          ["Shift", "Z"],
          ["Ctrl", "Y"],
        ],
        does: "Redo",
      },
      { keys: [["?"]], does: "This list" },
    ],
  },
];
