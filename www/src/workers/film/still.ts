import type { FrameSize } from "./format/sink";

/** What writes frames of one size as PNG, each a file; all opaque, or all with what is clear left clear. */
export function stillOf(
  { width, height }: Pick<FrameSize, "width" | "height">,
  opaque: boolean,
): (pixels: Uint8ClampedArray<ArrayBuffer>) => Promise<Uint8Array<ArrayBuffer>> {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { alpha: !opaque, willReadFrequently: true });
  return async (pixels) => {
    if (!context) throw new Error("This browser draws nothing in a worker. Choose another kind of file.");
    context.putImageData(new ImageData(pixels, width, height), 0, 0);
    const blob = await canvas.convertToBlob({ type: "image/png" });
    return new Uint8Array(await blob.arrayBuffer());
  };
}
