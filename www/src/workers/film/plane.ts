/** The tasks of workers that draw frames of the plane. */
import { weighted } from "#geometry/maps/weighted";
import type { Bend, MapRow, RasterOptions } from "#wasm/api";
import { loadBends, rasterized, type SheetHandle } from "#wasm/bend";
import type { Context } from "../lanes/task";
import type { FramePixels } from "./subject";

/** A picture that is bent: its pixels, RGBA with straight alpha. */
export interface SheetPicture {
  pixels: Uint8ClampedArray;
  width: number;
  height: number;
}

export interface SheetFrame {
  bend: Bend | null;
  /** Each way of the maps of its rectangle. */
  parts: number;
  options: Pick<RasterOptions, "width" | "height" | "view">;
}

const SHEET = "sheet";

export const planeTasks = {
  /** An attractor. */
  attractor(
    context: Context,
    { maps, weights, options }: { maps: MapRow[]; weights?: number[] | undefined; options: RasterOptions },
  ): Promise<FramePixels> {
    return measured(context, options, () => rasterized(weighted(maps, weights), options));
  },

  /** The picture that is bent from now on, in this lane. */
  async sheetBegin({ keep }: Context, { pixels, width, height }: SheetPicture): Promise<null> {
    const { Sheet } = await loadBends();
    (keep.get(SHEET) as SheetHandle | undefined)?.free();
    keep.set(SHEET, new Sheet(pixels, width, height));
    return null;
  },

  /** It, bent. */
  sheet(context: Context, { bend, parts, options }: SheetFrame): Promise<FramePixels> {
    const sheet = context.keep.get(SHEET) as SheetHandle | undefined;
    if (!sheet)
      throw { code: "export-lost", message: "The picture was lost on the way. Make the film again." };
    return measured(context, options, () => sheet.draw(bend, parts, options));
  },
};

async function measured(
  context: Context,
  { width, height }: { width: number; height: number },
  draw: () => Uint8ClampedArray | Promise<Uint8ClampedArray>,
): Promise<FramePixels> {
  const began = performance.now();
  // Declared as what may be shared memory; it never is.
  const data = (await draw()) as Uint8ClampedArray<ArrayBuffer>;
  context.transfer(data.buffer);
  return { width, height, data, took: performance.now() - began };
}
