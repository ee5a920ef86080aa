/** So many pixels a side are enough for copies that are half as large at most. */
const SIDE = 320;

/** The middle of a picture file as a square; rejects where the browser cannot read it. */
export async function squarePicture(file: Blob): Promise<ImageBitmap> {
  const whole = await createImageBitmap(file);
  try {
    const side = Math.min(whole.width, whole.height);
    const [x, y] = [Math.floor((whole.width - side) / 2), Math.floor((whole.height - side) / 2)];
    return await createImageBitmap(whole, x, y, side, side, {
      resizeWidth: SIDE,
      resizeHeight: SIDE,
      resizeQuality: "medium",
    });
  } finally {
    whole.close();
  }
}
