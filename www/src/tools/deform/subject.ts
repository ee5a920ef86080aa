import { aroundStanding, boxAround, changeDeformation, deformation } from "#document/deform/bend";
import { ownPicture, photograph, pictureMaps } from "#document/deform/picture";
import type { Deformation } from "#wasm/api";
import { inBox } from "./changes";
import { takeFile } from "./picture/take";

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
