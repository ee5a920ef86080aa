/** Keys that work anywhere while the fit is open, unless something is being typed or a dialog is open. */

import { fitDocument } from "#document/fit";
import { redo, undo } from "#document/scene";
import { type Focus, focusOf, type KeyPress } from "#ui/focus";
import { help } from "#ui/help";
import type { ShortcutRow } from "#ui/ShortcutTable";
import { brushSize, type Hand, hand, painting } from "./stage/brush";
import { fitStage } from "./stage/camera";
import { comparing, cutting, knotsShown, outlineShown, photoShown } from "./stage/layers";
import { canRedoStroke, canUndoStroke, redoStroke, undoStroke } from "./work/mask";

export type Command =
  | { do: "undo" | "redo" | "fit" | "outline" | "picture" | "knots" | "compare" | "help" }
  | { do: "hand"; by: Hand }
  | { do: "size"; by: number };

const HANDS: Record<string, Hand> = { "1": "move", "2": "keep", "3": "remove" };

/** The command of a key press, or null where the tool has none. */
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
    case "f":
      return { do: "fit" };
    case "o":
      return { do: "outline" };
    case "p":
      return { do: "picture" };
    case "k":
      return { do: "knots" };
    case "c":
      return { do: "compare" };
    case "[":
      return { do: "size", by: 1 / 1.25 };
    case "]":
      return { do: "size", by: 1.25 };
    case "?":
      return { do: "help" };
    default:
      return null;
  }
}

function run(command: Command): void {
  switch (command.do) {
    case "undo":
      // Strokes are no part of the document: while one paints, they are what is taken back.
      if (cutting.peek() && canUndoStroke()) undoStroke();
      else undo();
      break;
    case "redo":
      if (cutting.peek() && canRedoStroke()) redoStroke();
      else redo();
      break;
    case "fit":
      fitStage();
      break;
    case "outline":
      outlineShown.value = !outlineShown.peek();
      break;
    case "picture":
      photoShown.value = !photoShown.peek();
      break;
    case "knots":
      knotsShown.value = !knotsShown.peek();
      break;
    case "compare":
      comparing.value = true;
      break;
    case "help":
      help.value = true;
      break;
    case "hand":
      if (cutting.peek()) hand.value = command.by;
      break;
    case "size":
      if (painting.peek()) {
        brushSize.value = Number(Math.min(20, Math.max(0.2, brushSize.peek() * command.by)).toFixed(1));
      }
      break;
  }
}

/** Listens until the returned function is called. */
export function listen(): () => void {
  const end = new AbortController();
  const { signal } = end;
  const onKey = (event: KeyboardEvent) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
    if (fitDocument.peek().mode !== "outline") return;
    const command = commandOf(event, focusOf(event.target));
    if (command === null) return;
    event.preventDefault();
    run(command);
  };
  document.addEventListener("keydown", onKey, { signal });
  document.addEventListener(
    "keyup",
    (event) => {
      if (event.key.toLowerCase() === "c") comparing.value = false;
    },
    { signal },
  );
  return () => end.abort();
}

/** The visible list. */
export const SHORTCUTS: readonly { title: string; rows: readonly ShortcutRow[] }[] = [
  {
    title: "Picture and fit",
    rows: [
      { keys: [["C"]], does: "Hold: the outline without the fit" },
      { keys: [["O"]], does: "Hide the outline, show it" },
      { keys: [["K"]], does: "Show the knots, hide them" },
      { keys: [["P"]], does: "Hide the picture, show it" },
      { keys: [["F"]], does: "Fit it to the window" },
    ],
  },
  {
    title: "Cutting out",
    rows: [
      { keys: [["1"], ["2"], ["3"]], does: "Move, keep, remove" },
      { keys: [["["], ["]"]], does: "A smaller brush, a larger one" },
      {
        keys: [["←"], ["→"], ["↑"], ["↓"]],
        does: "Move the brush, where the picture has the focus; Shift finer",
      },
      { keys: [["Space"]], does: "Paint there; held, while it moves" },
      { keys: [["Escape"]], does: "Drop the stroke, put the brush away" },
    ],
  },
  {
    title: "Everywhere",
    rows: [
      { keys: [["Z"], ["Ctrl", "Z"]], does: "Undo: the last stroke first" },
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
