import { boxAround, changeDeformation, deformation } from "#document/deform/bend";
import { type Photograph, pictureMaps, showPicture } from "#document/deform/picture";
import { announce, notify } from "#document/notice";
import { smallBitmap } from "#workers/image/decode";
import { HEAD_BYTES, type Header, readHeader } from "#workers/image/header";
import { inBox } from "../changes";
import * as messages from "../messages";
import { damaged, kept, LONGEST, refusal, shortName } from "./words";

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
