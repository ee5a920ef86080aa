import type { DirectedCertificate, DirectedIfs, DirectedRasterOptions, StateConnectedness } from "#wasm/api";
import { directed } from "#wasm/directed";
import type { Context } from "../lanes/task";

interface Picture {
  system: DirectedIfs;
  options: DirectedRasterOptions;
}

interface Way {
  from: DirectedIfs;
  to: DirectedIfs;
  mode: "polar" | "linear";
  epsilon: number;
}

/** What is asked of graph-directed shapes. They compute with `directed`, which is started before the first. */
export const tasks = {
  async picture(context: Context, { system, options }: Picture): Promise<ImageBitmap> {
    const pixels = directed.rasterizeDirected(system, options) as Uint8ClampedArray<ArrayBuffer>;
    const bitmap = await createImageBitmap(new ImageData(pixels, options.width, options.height));
    context.transfer(bitmap);
    return bitmap;
  },
  verdicts: (
    _context: Context,
    { system, epsilon }: { system: DirectedIfs; epsilon: number },
  ): StateConnectedness[] => directed.directedConnectedness(system, { epsilon }),
  certify: (_context: Context, { from, to, ...options }: Way): DirectedCertificate =>
    directed.certifyDirected(from, to, options),
};

export type Tasks = typeof tasks;
