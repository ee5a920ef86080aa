import { MOST_MEGAPIXELS } from "./limits";

export interface Decoded {
  pixels: Uint8ClampedArray<ArrayBuffer>;
  width: number;
  height: number;
  /** As it is in the file, upright. */
  original: { width: number; height: number };
  /** The same as the pixels, to be shown. */
  bitmap: ImageBitmap;
}

/** The size that is worked on: at most so many pixels, no side of none. */
export function within(width: number, height: number, most: number): { width: number; height: number } {
  const factor = Math.min(1, Math.sqrt(most / (width * height)));
  const side = (pixels: number) => Math.max(1, Math.floor(pixels * factor));
  const size = { width: side(width), height: side(height) };
  // A side of one pixel is longer than its share.
  if (size.width * size.height <= most) return size;
  return size.width > size.height ? { width: most, height: 1 } : { width: 1, height: most };
}

/**
 * Decodes a picture on this thread, a worker's, to at most so many pixels. Throws where it is damaged, and null where
 * it turns out to be larger than its header said.
 */
export async function decode(file: Blob, most: number): Promise<Decoded | null> {
  const whole = await createImageBitmap(file);
  try {
    const original = { width: whole.width, height: whole.height };
    if (original.width * original.height > MOST_MEGAPIXELS * 1e6) return null;
    const { width, height } = within(original.width, original.height, most);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("no canvas");
    context.imageSmoothingQuality = "high";
    context.drawImage(whole, 0, 0, width, height);
    const { data } = context.getImageData(0, 0, width, height);
    return { pixels: data, width, height, original, bitmap: canvas.transferToImageBitmap() };
  } finally {
    whole.close();
  }
}
