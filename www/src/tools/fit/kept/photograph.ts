/** The photograph that a fit was made from goes along with it: a small part of it, with the leaf. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { type KeptPhotograph, MOST_PIXELS } from "#document/kept/fits";
import type { Box } from "#geometry/boxes";
import { raw } from "../work/outline";
import { boxOf, frameOfSize, opened, source } from "../work/source";

/** Left around the leaf, in parts of its longer side. */
const EDGE = 0.04;
const QUALITY = 0.85;

/** Whether what is fitted came from a photograph that is still there. */
export const photographed: ReadonlySignal<boolean> = computed(() => {
  const now = source.value;
  return opened.value !== null || (now.kind === "kept" && now.origin?.photograph != null);
});

/** A part of a picture in pixels from its upper left corner, and where that lies in the plane. */
interface Crop {
  left: number;
  top: number;
  across: number;
  down: number;
  box: KeptPhotograph["box"];
}

/** The whole pixels of a picture around a box of the plane, and a little more. */
export function cropOf({ x0, y0, x1, y1 }: Box, width: number, height: number): Crop {
  const { x, y, scale } = frameOfSize(width, height);
  const edge = EDGE * Math.max(x1 - x0, y1 - y0);
  const within = (pixel: number, most: number) => Math.min(most, Math.max(0, pixel));
  const left = within(Math.floor((x0 - edge) / scale + x), width - 1);
  const right = within(Math.ceil((x1 + edge) / scale + x), width);
  // Pixels count down, the plane goes up.
  const top = within(Math.floor(y - (y1 + edge) / scale), height - 1);
  const bottom = within(Math.ceil(y - (y0 - edge) / scale), height);
  const [across, down] = [Math.max(1, right - left), Math.max(1, bottom - top)];
  const box = [left - x, y - (top + down), left + across - x, y - top].map((side) => side * scale);
  return { left, top, across, down, box: box as unknown as KeptPhotograph["box"] };
}

/** The leaf of the photograph on the stage, cut out along its outline and made small; null where there is none. */
export async function croppedPhotograph(): Promise<KeptPhotograph | null> {
  const now = source.peek();
  if (now.kind === "kept") return now.origin?.photograph ?? null;
  const points = raw.peek();
  if (now.kind !== "picture" || !points) return null;
  const { bitmap, width, height } = now.picture;
  const { left, top, across, down, box } = cropOf(boxOf(points), width, height);
  const factor = Math.min(1, MOST_PIXELS / Math.max(across, down));
  const canvas = new OffscreenCanvas(
    Math.max(1, Math.round(across * factor)),
    Math.max(1, Math.round(down * factor)),
  );
  const context = canvas.getContext("2d");
  if (!context) return null;
  const [x0, y0, x1, y1] = box;
  context.beginPath();
  for (let i = 0; i + 1 < points.length; i += 2) {
    context.lineTo(
      (((points[i] ?? 0) - x0) / (x1 - x0)) * canvas.width,
      ((y1 - (points[i + 1] ?? 0)) / (y1 - y0)) * canvas.height,
    );
  }
  context.clip();
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, left, top, across, down, 0, 0, canvas.width, canvas.height);
  // A browser that does not write WebP gives a PNG.
  return { box, blob: await canvas.convertToBlob({ type: "image/webp", quality: QUALITY }) };
}
