import type { Header } from "#workers/image/header";
import { inWords, MOST_MEGAPIXELS, shortName as shortOf } from "#workers/image/limits";
import { otherWords } from "#workers/image/signature";
import * as messages from "../messages";

/** The longest side that is kept, in pixels. */
export const LONGEST = 2048;

const STAYS = messages.pictureOnStageUnchanged;

/** Why a file is not taken, or null if it may be decoded. */
export function refusal(name: string, { kind, other, size }: Header): string | null {
  if (kind === "svg") {
    return messages.isDrawing(name, STAYS);
  }
  if (other !== undefined) return messages.isOther(name, otherWords(other), STAYS);
  if (kind === "unknown") {
    return messages.isUnknown(name, STAYS);
  }
  // An AVIF may not say; whatever else does not is not whole.
  if (!size) return kind === "avif" ? null : damaged(name);
  const megapixels = (size.width * size.height) / 1e6;
  if (megapixels > MOST_MEGAPIXELS) {
    return messages.isTooLarge(name, inWords(size), MOST_MEGAPIXELS, STAYS);
  }
  return null;
}

export function damaged(name: string): string {
  return messages.isDamaged(name, STAYS);
}

/** The size that is kept: no side longer than `LONGEST`, none shorter than a pixel. */
export function kept(width: number, height: number): { width: number; height: number } {
  const factor = Math.min(1, LONGEST / Math.max(width, height, 1));
  const side = (pixels: number) => Math.max(1, Math.round(pixels * factor));
  return { width: side(width), height: side(height) };
}

/** A name that fits a line. */
export function shortName(name: string): string {
  return shortOf(name, messages.picture);
}
