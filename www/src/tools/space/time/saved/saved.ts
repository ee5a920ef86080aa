/** An animation as a file that Frond reads again: shapes and keys, or every frame. */
import type { Space, SpaceView } from "#wasm/api";
import * as messages from "../messages";
import { type FramesRead, readFrames, viewIn } from "./saved-frames";

/** Larger files are none of ours. */
export const MOST_BYTES = 64e6;

/** What the document says of an animation. */
export interface Kept {
  packed: string;
  at: number;
  view?: SpaceView;
}

interface SavedAnimation extends Kept {
  frond: "space";
  /** What `packed` says, for people and programs: it is not read. */
  space: Space;
}

/** The parameters of every frame, and what they were made of; none where another program made them. */
export interface SavedFrames extends FramesRead {
  kept?: Kept;
}

export function savedText(animation: Omit<SavedAnimation, "frond">): string {
  return JSON.stringify({ frond: "space", ...animation } satisfies SavedAnimation, null, 1);
}

/** What a file holds, or why it is none of these, in words. */
export function readSaved(text: string): Kept | SavedFrames | { problem: string } {
  let found: unknown;
  try {
    found = JSON.parse(text);
  } catch {
    return { problem: messages.thisNotJsonFile };
  }
  const record = typeof found === "object" && found !== null ? (found as Record<string, unknown>) : {};
  const kept = keptIn(record);
  if (Array.isArray(record["frames"])) {
    const read = readFrames(record, record["frames"]);
    return kept && !("problem" in read) ? { ...read, kept } : read;
  }
  if (record["frond"] !== "space" || !kept) {
    return {
      problem: messages.thisFileContainsNoAnimation,
    };
  }
  return kept;
}

function keptIn({ packed, at, view: seen }: Record<string, unknown>): Kept | null {
  if (typeof packed !== "string") return null;
  const view = viewIn(seen);
  return {
    packed,
    at: typeof at === "number" && Number.isFinite(at) && at >= 0 ? at : 0,
    ...(view ? { view } : {}),
  };
}
