import { weighted } from "#geometry/maps/weighted";
import type { MapRow, RasterOptions } from "#wasm/api";
import { rasterized } from "#wasm/bend";
import type { Context } from "../lanes/task";

export interface FrameOf {
  maps: MapRow[];
  weights: number[] | undefined;
  options: RasterOptions;
  /** See `bendsFor`. */
  bends: WebAssembly.Module | undefined;
}

export interface Frame {
  image: ImageBitmap;
  /** How long it took to draw. */
  milliseconds: number;
}

export const tasks = {
  /** One picture of an attractor. */
  async frame({ transfer }: Context, { maps, weights, options, bends }: FrameOf): Promise<Frame> {
    const start = performance.now();
    const pixels = await rasterized(weighted(maps, weights), options, bends);
    const { width, height } = options;
    const data = new ImageData(pixels as Uint8ClampedArray<ArrayBuffer>, width, height);
    const image = await createImageBitmap(data);
    transfer(image);
    return { image, milliseconds: performance.now() - start };
  },
};

export type Tasks = typeof tasks;
