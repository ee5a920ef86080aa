/** What a picture is to be saved as. Pure, for the tests. */

import * as messages from "../messages";
import { bytesWords, LEAST_SIDE } from "../plan";

export interface PicturePlan {
  width: number;
  height: number;
  /** "#rrggbb"; null: as on the stage. */
  ground: string | null;
  /** Whether what is clear stays clear. */
  clear: boolean;
  /** Whether it carries the link of the document. */
  link: boolean;
  /** Whether edges are smoothed, where that is a choice. */
  smooth: boolean;
}

export const MOST_PICTURE_SIDE = 8192;
/** Pixels of what cannot be drawn in strips. */
export const MOST_WHOLE = 4096 ** 2;

/** Why it cannot be made, in words that say what to do; null where it can. */
export function pictureProblem({ width, height }: PicturePlan, inStrips: boolean): string | null {
  for (const side of [width, height]) {
    if (!(Number.isInteger(side) && side >= LEAST_SIDE && side <= MOST_PICTURE_SIDE)) {
      return messages.eachSide(LEAST_SIDE, MOST_PICTURE_SIDE);
    }
  }
  if (!inStrips && width * height > MOST_WHOLE) {
    return messages.thisCanSavedWith;
  }
  return null;
}

/** Bytes of a PNG for each pixel that shows something, and for each other. */
const LIT_BYTES = 0.9;
const EMPTY_BYTES = 0.01;

export function pictureWords({ width, height }: PicturePlan, lit: number): string {
  const bytes = width * height * (LIT_BYTES * lit + EMPTY_BYTES) + 500;
  return messages.pictureSize(width, height, bytesWords(bytes));
}
