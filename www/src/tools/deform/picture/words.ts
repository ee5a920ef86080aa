import type { Header } from "#workers/image/header";
import { inWords, MOST_MEGAPIXELS, shortName as shortOf } from "#workers/image/limits";
import { otherWords } from "#workers/image/signature";

/** The longest side that is kept, in pixels. */
export const LONGEST = 2048;

const STAYS = "The picture on the stage stays as it is.";

/** Why a file is not taken, or null if it may be decoded. */
export function refusal(name: string, { kind, other, size }: Header): string | null {
  if (kind === "svg") {
    return `“${name}” is a drawing (SVG), not a picture made of pixels: save it as PNG first. ${STAYS}`;
  }
  if (other !== undefined) return `“${name}” is ${otherWords(other)} ${STAYS}`;
  if (kind === "unknown") {
    return `“${name}” is no picture that can be read here: PNG, JPEG, WebP, AVIF and GIF can be. ${STAYS}`;
  }
  // An AVIF may not say; whatever else does not is not whole.
  if (!size) return kind === "avif" ? null : damaged(name);
  const megapixels = (size.width * size.height) / 1e6;
  if (megapixels > MOST_MEGAPIXELS) {
    return `“${name}” has ${inWords(size)}. Up to ${MOST_MEGAPIXELS} can be bent: make it smaller first. ${STAYS}`;
  }
  return null;
}

export function damaged(name: string): string {
  return `“${name}” is damaged or ends too soon, so that it cannot be read. ${STAYS}`;
}

/** The size that is kept: no side longer than `LONGEST`, none shorter than a pixel. */
export function kept(width: number, height: number): { width: number; height: number } {
  const factor = Math.min(1, LONGEST / Math.max(width, height, 1));
  const side = (pixels: number) => Math.max(1, Math.round(pixels * factor));
  return { width: side(width), height: side(height) };
}

/** A name that fits a line. */
export function shortName(name: string): string {
  return shortOf(name, "Picture");
}
