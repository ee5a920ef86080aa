/** Keys that work anywhere while the deformation tool is open, unless something is being typed or a dialog is open. */

import { deformation, phasePlaying } from "#document/deform/bend";
import { edit, redo, undo } from "#document/scene";
import { addStep } from "#format/numbers";
import { fitStage } from "#stage/gestures";
import { type Focus, focusOf, type KeyPress } from "#ui/focus";
import { help } from "#ui/help";
import type { ShortcutRow } from "#ui/ShortcutTable";
import type { Colouring } from "#wasm/api";
import { pausePhase, playPhase, scrubPhase } from "./clock";
import { gallery } from "./dialogs";
import { gridShown } from "./mesh/shown";
import { addKey } from "./strip/TimeOptions";
import { withColouring } from "./tint";

export type Command =
  | { do: "play" | "undo" | "redo" | "fit" | "grid" | "key" | "shape" | "help" }
  | { do: "scrub"; by: number }
  | { do: "frame"; by: 1 | -1 }
  | { do: "colour"; by: Colouring };

const COLOURS: Record<string, Colouring> = { "1": "map", "2": "address", "3": "density", "4": "grid" };

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
  if (key === " ") return focus === "none" || focus === "slider" ? { do: "play" } : null;
  if (key === "ArrowLeft" || key === "ArrowRight") {
    if (focus === "slider" || focus === "control") return null;
    return { do: "scrub", by: (key === "ArrowLeft" ? -1 : 1) * (shiftKey ? 0.001 : 0.01) };
  }
  const colour = COLOURS[key];
  if (colour !== undefined) return { do: "colour", by: colour };
  switch (key.toLowerCase()) {
    case "[":
      return { do: "frame", by: -1 };
    case "]":
      return { do: "frame", by: 1 };
    case "z":
      return { do: shiftKey ? "redo" : "undo" };
    case "f":
      return { do: "fit" };
    case "g":
      return { do: "grid" };
    case "k":
      return { do: "key" };
    case "s":
      return { do: "shape" };
    case "?":
      return { do: "help" };
    default:
      return null;
  }
}

/** The moment of the next key in a direction, round the end where it loops; the same moment where there is none. */
export function nextKey(moments: readonly number[], phase: number, by: 1 | -1, loop: boolean): number {
  const ahead = by > 0 ? moments.find((x) => x > phase + 1e-3) : moments.findLast((x) => x < phase - 1e-3);
  return ahead ?? (loop ? moments.at(by > 0 ? 0 : -1) : undefined) ?? phase;
}

function run(command: Command): void {
  switch (command.do) {
    case "play":
      if (phasePlaying.peek()) pausePhase();
      else playPhase();
      break;
    case "undo":
      undo();
      break;
    case "redo":
      redo();
      break;
    case "fit":
      fitStage();
      break;
    case "grid":
      gridShown.value = !gridShown.peek();
      break;
    case "key":
      addKey();
      break;
    case "shape":
      gallery.value = true;
      break;
    case "help":
      help.value = true;
      break;
    case "scrub":
      scrubPhase(addStep(deformation.peek().phase, command.by));
      break;
    case "frame": {
      const { keys, phase, loop } = deformation.peek();
      const moments = keys.map((key) => key.at);
      scrubPhase(nextKey(moments, phase, command.by, loop));
      break;
    }
    case "colour":
      edit((before) => withColouring(before, command.by, deformation.peek()));
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
    title: "Time",
    rows: [
      { keys: [["Space"]], does: "Play, pause" },
      { keys: [["←"], ["→"]], does: "Back, forward by 1%; Shift finer" },
      { keys: [["["], ["]"]], does: "To the key frame before, after" },
      { keys: [["K"]], does: "Add a key frame" },
    ],
  },
  {
    title: "Key frame, in focus",
    rows: [
      { keys: [["←"], ["→"]], does: "Move in time; Shift finer, Alt farther" },
      { keys: [["["], ["]"]], does: "To its neighbour" },
      { keys: [["Delete"], ["−"]], does: "Delete it" },
    ],
  },
  {
    title: "Handle of the grid, in focus",
    rows: [
      { keys: [["←"], ["→"], ["↑"], ["↓"]], does: "Move it; Shift farther, Alt finer" },
      { keys: [["["], ["]"]], does: "To the handle before, after" },
      { keys: [["Ctrl", "←"]], does: "To its neighbour" },
      { keys: [["Space"]], does: "Choose it, let it go" },
      { keys: [["Ctrl", "A"]], does: "Choose all" },
      { keys: [["Delete"]], does: "Put it back" },
    ],
  },
  {
    title: "Shape and picture",
    rows: [
      { keys: [["S"]], does: "Another shape" },
      { keys: [["G"]], does: "Hide the grid, show it" },
      { keys: [["F"]], does: "Fit the picture to the window" },
      { keys: [["1"], ["2"], ["3"], ["4"]], does: "Colour by map, address, density, grid" },
    ],
  },
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
