import { aroundStanding, boxAround, changeDeformation, deformation } from "#document/deform/bend";
import { ownPicture, type Photograph, photograph, pictureMaps, showPicture } from "#document/deform/picture";
import { announce, notify } from "#document/notice";
import type { Deformation } from "#wasm/api";
import { smallBitmap } from "#workers/image/decode";
import { HEAD_BYTES, type Header, readHeader } from "#workers/image/header";
import { inWords, MOST_MEGAPIXELS, shortName as shortOf } from "#workers/image/limits";
import { otherWords } from "#workers/image/signature";
import { inBox } from "../deform-edits";
import * as messages from "../messages";

/** The longest side that is kept, in pixels. */
const LONGEST = 2048;

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

function damaged(name: string): string {
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

let latest = 0;

/** Takes a file as the picture that is bent; says why if it cannot be. The last one that was given counts. */
export async function takeFile(file: Blob, given: string): Promise<void> {
  const turn = ++latest;
  const name = shortName(given);
  try {
    const head = new Uint8Array(await file.slice(0, HEAD_BYTES).arrayBuffer());
    const header = readHeader(head);
    const refused = refusal(name, header);
    if (refused !== null) {
      refuse(refused);
      return;
    }
    const photograph = await decode(file, name, header);
    if (turn === latest) show(photograph, messages.nowOnStage(name));
  } catch {
    if (turn === latest) refuse(damaged(name));
  }
}

/** Goes back to the sample. */
export function takeSample(): void {
  latest++;
  show(null, messages.sampleOnStage);
}

function refuse(text: string): void {
  notify({ kind: "error", text });
}

/** Shows it, with the grid round it if it was round the last one. */
function show(photograph: Photograph | null, words: string): void {
  const before = boxAround(pictureMaps.peek());
  const follows = deformation.peek().box.every((side, i) => Math.abs(side - (before[i] ?? side)) < 1e-6);
  showPicture(photograph);
  if (follows) changeDeformation((now) => inBox(now, boxAround(pictureMaps.peek())));
  announce(words);
}

async function decode(file: Blob, name: string, { kind, size }: Header): Promise<Photograph> {
  let bitmap = await smallBitmap(file, kind === "avif" ? undefined : size, 2 * LONGEST ** 2);
  const { width, height } = kept(bitmap.width, bitmap.height);
  if (width !== bitmap.width || height !== bitmap.height) {
    const whole = bitmap;
    bitmap = await createImageBitmap(whole, {
      resizeWidth: width,
      resizeHeight: height,
      resizeQuality: "high",
    });
    whole.close();
  }
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(messages.noCanvas);
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { pixels: context.getImageData(0, 0, width, height).data, width, height, name };
}

/** Bends a shape, or a picture, with the grid round it. */
export function setSubject(subject: Deformation["subject"]): void {
  changeDeformation((now) => {
    const box = subject === "picture" ? boxAround(pictureMaps.peek()) : aroundStanding.peek();
    return inBox({ ...now, subject }, box);
  });
}

/** A photograph that was opened takes the place of what is bent. */
export async function openPhotograph(file: File): Promise<void> {
  const before = photograph.peek();
  await takeFile(file, file.name);
  if (photograph.peek() !== before && ownPicture.peek() && deformation.peek().subject !== "picture")
    setSubject("picture");
}
