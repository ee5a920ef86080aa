import type {
  DigitSystem,
  DirectedCertificate,
  DirectedIfs,
  DirectedRasterOptions,
  GridIntersection,
  StateConnectedness,
} from "#wasm/api";
import { directed } from "#wasm/directed";
import { toError } from "#wasm/error";
import type { Context } from "../lanes/task";

interface Picture {
  system: DirectedIfs;
  options: DirectedRasterOptions;
}

interface Meeting {
  first: DigitSystem;
  second: DigitSystem;
  shift: { numerators: [number, number]; denominator: number };
  options: DirectedRasterOptions;
}

/** What two shapes of a grid share, or why it is not worked out; the second where it lies, and what they share. */
export interface Met {
  found: GridIntersection | null;
  problem: string | null;
  second: ImageBitmap;
  shared: ImageBitmap | null;
}

interface Way {
  from: DirectedIfs;
  to: DirectedIfs;
  mode: "polar" | "linear";
  epsilon: number;
}

async function drawn(context: Context, { system, options }: Picture): Promise<ImageBitmap> {
  const pixels = directed.rasterizeDirected(system, options) as Uint8ClampedArray<ArrayBuffer>;
  const bitmap = await createImageBitmap(new ImageData(pixels, options.width, options.height));
  context.transfer(bitmap);
  return bitmap;
}

/** What is asked of graph-directed shapes. They compute with `directed`, which is started before the first. */
export const tasks = {
  picture: drawn,
  async meeting(context: Context, { first, second, shift, options }: Meeting): Promise<Met> {
    const { numerators, denominator } = shift;
    const by = numerators.map((p) => p / denominator) as [number, number];
    const moved = await drawn(context, { system: directed.digitShape(second, { shift: by }), options });
    // What is too much to be worked out leaves the shapes to be seen.
    let found: GridIntersection | null = null;
    let problem: string | null = null;
    try {
      found = directed.gridIntersection(first, second, shift);
    } catch (thrown) {
      problem = toError(thrown).message;
    }
    const system = found?.system;
    return {
      found,
      problem,
      second: moved,
      shared: system ? await drawn(context, { system, options }) : null,
    };
  },
  verdicts: (
    _context: Context,
    { system, epsilon }: { system: DirectedIfs; epsilon: number },
  ): StateConnectedness[] => directed.directedConnectedness(system, { epsilon }),
  certify: (_context: Context, { from, to, ...options }: Way): DirectedCertificate =>
    directed.certifyDirected(from, to, options),
};

export type Tasks = typeof tasks;
