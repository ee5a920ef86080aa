/** A photograph that lies on its side or upside down is turned, and what was painted on it goes along. */
import { announce, notify, wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import { isStopped, Latest } from "#workers/lanes/latest";
import * as messages from "../messages";
import { keepFor, part, settings } from "./mask";
import { opened, PICTURE_LANE, replacePicture } from "./source";

/** Quarters of a turn, clockwise. */
export type Quarters = 1 | 2 | 3;

const WORDS: Record<Quarters, string> = {
  1: messages.rotatedQuarterTurnTo,
  2: messages.turnedUpsideDown,
  3: messages.rotatedQuarterTurnToLeft,
};

/** Where points x0, y0, x1, y1, .. of a picture of that size, y down, come to lie. */
export function turned(
  points: readonly number[],
  { width, height }: { width: number; height: number },
  quarters: Quarters,
): number[] {
  const out: number[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [points[i] ?? 0, points[i + 1] ?? 0];
    if (quarters === 1) out.push(height - y, x);
    else if (quarters === 2) out.push(width - x, height - y);
    else out.push(y, width - x);
  }
  return out;
}

const turns = new Latest();

/** Turns the picture that is worked on. */
export async function turnPicture(quarters: Quarters): Promise<void> {
  const picture = opened.peek();
  if (!picture) return;
  const signal = turns.begin();
  try {
    const next = await fitTask("turnPicture", { picture, quarters }, { lane: PICTURE_LANE, signal });
    if (signal.aborted || opened.peek() !== picture) {
      next.bitmap.close();
      fitTask("closeFile", { id: next.id }, { lane: PICTURE_LANE }).catch(() => {});
      return;
    }
    const now = settings.peek();
    const strokes = now.strokes.map((stroke) => ({
      ...stroke,
      points: turned(stroke.points, picture, quarters),
    }));
    keepFor(next.id, { ...now, strokes }, part.peek());
    replacePicture(next);
    announce(messages.photoIs(WORDS[quarters]));
  } catch (problem) {
    if (!isStopped(problem)) notify({ kind: "error", text: messages.notRotated(wordsOf(problem)) });
  }
}
