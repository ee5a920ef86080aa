/** Reads QR codes, off the page: a frame of a camera takes longer than a frame of the screen. */
import { type Care, textsIn } from "./read";

export interface Ask {
  id: number;
  picture: ImageBitmap;
  care: Care;
}

export interface Answer {
  id: number;
  texts: string[];
}

addEventListener("message", ({ data: { id, picture, care } }: MessageEvent<Ask>) => {
  const answer = (texts: string[]) => {
    picture.close();
    postMessage({ id, texts } satisfies Answer);
  };
  textsIn(picture, care).then(answer, () => answer([]));
});
