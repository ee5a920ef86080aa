/** What the stage of space says. Pure. */
import { countWords } from "#format/verdict";
import * as messages from "../messages";
import type { Painted } from "./surface/painter";

/** How much of the picture is there. */
export function statusWords(painted: Pick<Painted, "backend" | "complete" | "settled" | "points">): string {
  const { backend, complete, settled, points } = painted;
  if (backend === null) return messages.preparing;
  if (complete) return settled ? messages.completePicture : messages.completePictureSmoothing;
  if (backend === "canvas") return messages.coarsePicture;
  return points > 0 ? messages.pointsCompleting(countWords(points)) : messages.drawing;
}

/** How much there is. */
export function countsWords(objects: number, maps: number): string {
  const of = `${maps} ${maps === 1 ? "map" : "maps"}`;
  return objects === 1 ? of : messages.objectsOf(objects, of);
}

const DOES = { turn: messages.turns, move: messages.moves2, scale: messages.scales2 } as const;

/** What a drag is about, where that is no matter of course. */
export function handWords(
  hand: "look" | "turn" | "move" | "scale",
  objects: readonly { name: string }[],
  chosen: number,
): string | null {
  if (hand === "look" || objects.length < 2) return null;
  return `${DOES[hand]} ${objects[chosen]?.name ?? "nothing"}`;
}

type Trouble = "behind" | "nothing" | null;

/** Why there is nothing to see: by the ball at once, by the complete picture when it is there. */
export function troubleOf(
  where: "before" | "around" | "behind" | null,
  painted: Pick<Painted, "complete" | "empty">,
): Trouble {
  if (where === "behind") return "behind";
  return painted.complete && painted.empty ? "nothing" : null;
}

export const TROUBLE_WORDS = {
  behind: messages.everythingBehindEye,
  nothing: messages.nothingInView,
} as const;

/** Of which objects the eye is within reach. */
export function insideWords(names: readonly string[]): string | null {
  const [first] = names;
  if (first === undefined) return null;
  if (names.length === 1) return messages.eyeInside(first);
  return messages.eyeInsideSeveral(names.length);
}
