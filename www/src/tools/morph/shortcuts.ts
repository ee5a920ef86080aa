/** Keys that work anywhere on the page, unless something is being typed or a dialog is open. */

import { curved } from "#document/curve/curve";
import { selection } from "#document/morph";
import { pause, play, playing } from "#document/playback";
import { edit, redo, scene, undo } from "#document/scene";
import { addStep } from "#format/numbers";
import { fitStage } from "#stage/gestures";
import { type Focus, focusOf, type KeyPress } from "#ui/focus";
import { help } from "#ui/help";
import type { ShortcutRow } from "#ui/ShortcutTable";
import type { Colouring } from "#wasm/api";
import { gallery } from "./dialogs";
import { frames } from "./strip/FilmStrip";
import { scrubTo } from "./strip/scrub";

export type Command =
  | { do: "play" | "undo" | "redo" | "fit" | "edit" | "gallery" | "help" }
  | { do: "scrub"; by: number }
  | { do: "frame"; by: 1 | -1 }
  | { do: "colour"; by: Colouring };

const COLOURS: Record<string, Colouring> = { "1": "map", "2": "address", "3": "density" };

/** The command of a key press, or null where the page has none. */
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
    case "e":
      return { do: "edit" };
    case "g":
      return { do: "gallery" };
    case "?":
      return { do: "help" };
    default:
      return null;
  }
}

/** The moment of the next frame of the film, in a direction; the end where there is none. */
export function nextFrame(moments: readonly number[], t: number, by: 1 | -1): number {
  const sorted = [...moments].sort((x, y) => x - y);
  const ahead = by > 0 ? sorted.find((x) => x > t + 1e-6) : sorted.findLast((x) => x < t - 1e-6);
  return ahead ?? (by > 0 ? 1 : 0);
}

function run(command: Command): void {
  switch (command.do) {
    case "play":
      if (playing.peek()) pause();
      else play();
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
    case "edit":
      // A closed curve is edited where it is fitted.
      if (curved.peek()) break;
      selection.value = selection.peek() === null ? { target: "a", map: 0 } : null;
      break;
    case "gallery":
      gallery.value = selection.peek()?.target ?? "a";
      break;
    case "help":
      help.value = true;
      break;
    case "scrub":
      scrubTo(addStep(scene.peek().t, command.by));
      break;
    case "frame": {
      const moments = frames.peek().map((frame) => frame.t);
      scrubTo(nextFrame(moments, scene.peek().t, command.by));
      break;
    }
    case "colour":
      edit((before) => (before.colouring === command.by ? before : { ...before, colouring: command.by }));
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
      { keys: [["←"], ["→"]], does: "Back, forward by 1%" },
      {
        keys: [
          ["Shift", "←"],
          ["Shift", "→"],
        ],
        does: "Back, forward by 0.1%",
      },
      { keys: [["["], ["]"]], does: "To the frame before, after" },
    ],
  },
  {
    title: "Path, with a point in focus",
    rows: [
      { keys: [["←"], ["→"], ["↑"], ["↓"]], does: "Move by 0.01; Shift finer, Alt coarser" },
      { keys: [["+"], ["Enter"]], does: "Add a way point" },
      { keys: [["Delete"], ["−"]], does: "Remove the way point" },
    ],
  },
  {
    title: "Map, in focus",
    rows: [
      { keys: [["←"], ["→"], ["↑"], ["↓"]], does: "Move the cross; Shift finer, Alt farther" },
      { keys: [["+"], ["−"], ["0"]], does: "Nearer, farther, all of it" },
      { keys: [["Enter"]], does: "Show the shape under the cross" },
      { keys: [["A"]], does: "Make it a way point" },
    ],
  },
  {
    title: "Shapes and picture",
    rows: [
      { keys: [["G"]], does: "Gallery" },
      { keys: [["E"]], does: "Edit the maps" },
      { keys: [["F"]], does: "Fit the picture to the window" },
      { keys: [["1"], ["2"], ["3"]], does: "Colour by map, address, density" },
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
