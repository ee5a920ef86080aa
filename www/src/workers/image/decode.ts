import { MOST_MEGAPIXELS } from "./limits";

interface Size {
  width: number;
  height: number;
}

export interface Decoded extends Size {
  pixels: Uint8ClampedArray<ArrayBuffer>;
  /** As it is in the file, upright. */
  original: Size;
  /** The same as the pixels, to be shown. */
  bitmap: ImageBitmap;
}

/** The size that is worked on: at most so many pixels, no side of none. */
export function within(width: number, height: number, most: number): Size {
  const factor = Math.min(1, Math.sqrt(most / (width * height)));
  const side = (pixels: number) => Math.max(1, Math.floor(pixels * factor));
  const size = { width: side(width), height: side(height) };
  // A side of one pixel is longer than its share.
  if (size.width * size.height <= most) return size;
  return size.width > size.height ? { width: most, height: 1 } : { width: 1, height: most };
}

/**
 * A picture, made smaller while it is decoded where its header says that it has more pixels than are wanted. Still a
 * little more may come: of a picture that lies on its side in the file the other side is the width.
 */
export function smallBitmap(file: Blob, size: Size | undefined, most: number): Promise<ImageBitmap> {
  if (!size || size.width * size.height <= most) return createImageBitmap(file);
  const { width } = within(size.width, size.height, most);
  // The browser finds the height.
  return createImageBitmap(file, { resizeWidth: width, resizeQuality: "high" });
}

/** The size of a picture in its file, upright, from what its header says and how it has been decoded. */
export function upright(size: Size | undefined, decoded: Size): Size {
  // A header that says less than there is lies.
  if (!size || size.width * size.height < decoded.width * decoded.height) {
    return { width: decoded.width, height: decoded.height };
  }
  const turned = size.width > size.height !== decoded.width > decoded.height && size.width !== size.height;
  return turned ? { width: size.height, height: size.width } : size;
}

/**
 * Decodes a picture on this thread, a worker's, to at most so many pixels. Throws where it is damaged, and null where
 * it turns out to be larger than may be decoded. `size` is what its header says; without it all of it is decoded.
 */
export async function decode(file: Blob, most: number, size?: Size): Promise<Decoded | null> {
  const small = await smallBitmap(file, size, most);
  try {
    const original = upright(size, small);
    if (original.width * original.height > MOST_MEGAPIXELS * 1e6) return null;
    const { width, height } = within(small.width, small.height, most);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("no canvas");
    context.imageSmoothingQuality = "high";
    context.drawImage(small, 0, 0, width, height);
    const { data } = context.getImageData(0, 0, width, height);
    return { pixels: data, width, height, original, bitmap: canvas.transferToImageBitmap() };
  } finally {
    small.close();
  }
}
