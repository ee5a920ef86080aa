import { solid } from "../../../engine/space/module";
import { notify, wordsOf } from "../../../state/notice";
import { edit } from "../../../state/scene";
import { pauseSpace } from "./clock";
import { readSaved } from "./saved";

/** Larger files are none of ours. */
const MOST_BYTES = 4e6;

/** Asks for a file that was saved as shapes and keys, and opens it: one step to undo. */
export function openAnimation(): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,application/json";
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) void take(file);
  });
  input.click();
}

async function take(file: File): Promise<void> {
  try {
    if (file.size > MOST_BYTES)
      throw new Error("This file is too large to be an animation of shapes and keys.");
    const found = readSaved(await file.text());
    if ("problem" in found) throw new Error(found.problem);
    // What cannot be read changes nothing.
    if (!readable(found.packed))
      throw new Error("This file is damaged. Save the animation again, and open that.");
    pauseSpace();
    edit((now) => ({ ...now, space: found }));
    notify({ kind: "info", text: `Opened ${file.name}.` });
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
  }
}

function readable(packed: string): boolean {
  try {
    solid.unpackSpace(packed);
    return true;
  } catch {
    return false;
  }
}
