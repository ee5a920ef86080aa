/** An animation as a file that Frond reads again: shapes and keys, not frames. */
import type { Space, SpaceView } from "../../../engine/api";

export interface SavedAnimation {
  frond: "space";
  /** What is read back. */
  packed: string;
  at: number;
  view?: SpaceView;
  /** The same for people and programs: it is not read. */
  space: Space;
}

export function savedText(animation: Omit<SavedAnimation, "frond">): string {
  return JSON.stringify({ frond: "space", ...animation } satisfies SavedAnimation, null, 1);
}

/** What a file holds, or why it is none of these, in words. */
export function readSaved(
  text: string,
): { packed: string; at: number; view?: SpaceView } | { problem: string } {
  let found: unknown;
  try {
    found = JSON.parse(text);
  } catch {
    return {
      problem: "This is no JSON file. Choose one that the export of space saved as “Shapes and keys”.",
    };
  }
  const record = typeof found === "object" && found !== null ? (found as Record<string, unknown>) : {};
  if (Array.isArray(record["frames"])) {
    return {
      problem:
        "This file has the parameters of every frame, and no keys: it is for other programs. Choose one that was saved as “Shapes and keys”.",
    };
  }
  const { frond, packed, at } = record;
  if (frond !== "space" || typeof packed !== "string") {
    return {
      problem: "There is no animation of space in this file. Choose one that the export of space saved.",
    };
  }
  const view = viewIn(record["view"]);
  return {
    packed,
    at: typeof at === "number" && Number.isFinite(at) && at >= 0 ? at : 0,
    ...(view ? { view } : {}),
  };
}

/** A view that can be looked from, or nothing. */
function viewIn(value: unknown): SpaceView | null {
  if (typeof value !== "object" || value === null) return null;
  const { target, distance, turn, tilt, angle, holds } = value as Record<string, unknown>;
  const number = (x: unknown): x is number =>
    typeof x === "number" && Number.isFinite(x) && Math.abs(x) < 1e9;
  if (!Array.isArray(target) || target.length !== 3 || !target.every(number)) return null;
  if (!number(distance) || distance <= 0 || !number(turn) || !number(tilt)) return null;
  if (!number(angle) || angle <= 0 || angle >= Math.PI) return null;
  const [x, y, z] = target as [number, number, number];
  const view: SpaceView = { target: [x, y, z], distance, turn, tilt, angle };
  return holds === "eye" ? { ...view, holds } : view;
}
