/** A leaf cut out of its photograph. */

/**
 * The part of a picture, which lies on a box of the plane, that is inside an outline x0, y0, x1, y1, .., and so many
 * pixels away from it.
 */
export function cutOut(
  image: ImageBitmap,
  [x0, y0, x1, y1]: readonly [number, number, number, number],
  outline: Float64Array,
  away = 0,
): ImageData {
  const { width, height } = image;
  const context = new OffscreenCanvas(width, height).getContext("2d");
  if (!context) throw new Error("this browser draws on no canvas");
  context.beginPath();
  for (let i = 0; i + 1 < outline.length; i += 2) {
    context.lineTo(
      (((outline[i] ?? 0) - x0) / (x1 - x0)) * width,
      ((y1 - (outline[i + 1] ?? 0)) / (y1 - y0)) * height,
    );
  }
  context.closePath();
  context.save();
  context.clip();
  context.drawImage(image, 0, 0);
  context.restore();
  if (away > 0) {
    context.globalCompositeOperation = "destination-out";
    context.lineWidth = 2 * away;
    context.stroke();
  }
  return context.getImageData(0, 0, width, height);
}
