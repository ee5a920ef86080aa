import { notify, wordsOf } from "#document/notice";
import { edit } from "#document/scene";
import type { Space } from "#wasm/api";
import { solid } from "#wasm/space";
import { Frames } from "#workers/space/frames";
import { pauseSpace } from "../clock";
import * as messages from "../messages";
import { type Kept, MOST_BYTES, readSaved, type SavedFrames } from "./saved";
import { keysOf, madeOf } from "./saved-frames";

/** Asks for a file that the export saved, and opens it: one step to undo. */
export function openAnimation(): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,application/json";
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) void takeAnimation(file);
  });
  input.click();
}

/** Opens it in place of what there is, or says why it cannot: then nothing changes. */
export async function takeAnimation(file: File): Promise<void> {
  try {
    if (file.size > MOST_BYTES) throw new Error(messages.thisFileLargerThan);
    const found = readSaved(await file.text());
    if ("problem" in found) throw new Error(found.problem);
    const { kept, what } = "frames" in found ? opened(found) : { kept: found, what: "" };
    if (!unpacked(kept)) throw new Error(messages.thisFileDamagedSave);
    pauseSpace();
    edit((now) => ({ ...now, space: kept }));
    notify({ kind: "info", text: messages.opened(file.name, what) });
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
  }
}

/** What frames were made of, where they are still what comes of it; else each of them as a key. */
function opened(file: SavedFrames): { kept: Kept; what: string } {
  const { kept } = file;
  const space = kept && unpacked(kept);
  if (kept && space && isMadeOf(file, kept, space)) return { kept, what: "" };
  const made = keysOf(file, space ?? solid.defaultSpace());
  if ("problem" in made) throw new Error(made.problem);
  const packed = solid.packSpace(made.space);
  // What cannot be played is told now.
  new solid.SpaceMotion(made.space).free();
  return { kept: { packed, at: 0 }, what: messages.eachFrame(file.frames.length) };
}

function isMadeOf(file: SavedFrames, { view }: Kept, space: Space): boolean {
  let frames: Frames | null = null;
  try {
    frames = new Frames(space);
    return madeOf(file, space, frames, view ?? solid.defaultView(space));
  } catch {
    return false;
  } finally {
    frames?.free();
  }
}

function unpacked({ packed }: Kept): Space | null {
  try {
    return solid.unpackSpace(packed);
  } catch {
    return null;
  }
}
