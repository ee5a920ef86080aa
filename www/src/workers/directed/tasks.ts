import type { Box } from "#geometry/boxes";
import type {
  DigitSystem,
  DirectedCertificate,
  DirectedFacts,
  DirectedIfs,
  DirectedMatch,
  DirectedRasterOptions,
  GridIntersection,
  StateConnectedness,
} from "#wasm/api";
import { directed } from "#wasm/directed";
import { toError } from "#wasm/error";
import { COARSE, EPSILON, fillLocus, type LocusSoFar } from "../lanes/locus-fill";
import type { Context } from "../lanes/task";
import { drawnAt, type Moment, systemAt, type Way } from "./moment";

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

interface MomentPicture {
  moment: Moment;
  options: DirectedRasterOptions;
}

function pixelsOf({ system, options }: Picture): Uint8ClampedArray<ArrayBuffer> {
  return directed.rasterizeDirected(system, options) as Uint8ClampedArray<ArrayBuffer>;
}

async function drawn(context: Context, picture: Picture): Promise<ImageBitmap> {
  const { width, height } = picture.options;
  const bitmap = await createImageBitmap(new ImageData(pixelsOf(picture), width, height));
  context.transfer(bitmap);
  return bitmap;
}

/** The box of the first state. */
function boxOf(system: DirectedIfs): Box | null {
  const [first] = directed.directedFacts(system).states;
  return first ? { x0: first.min[0], y0: first.min[1], x1: first.max[0], y1: first.max[1] } : null;
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
  certify: (_context: Context, { from, to, ...options }: Way & { epsilon: number }): DirectedCertificate =>
    directed.certifyDirected(from, to, options),
  /** The complete picture of a moment; throws where there is no attractor. */
  moment: (context: Context, { moment, options }: MomentPicture): Promise<ImageBitmap> =>
    drawn(context, { system: drawnAt(moment), options }),
  /** The same as pixels. */
  pixels(context: Context, { moment, options }: MomentPicture): Uint8ClampedArray<ArrayBuffer> {
    const pixels = pixelsOf({ system: drawnAt(moment), options });
    context.transfer(pixels.buffer);
    return pixels;
  },
  /** What is known of every state at a moment, what the states are made of, and where each lies. */
  known(
    _context: Context,
    { moment, epsilon }: { moment: Moment; epsilon: number },
  ): { system: DirectedIfs; facts: DirectedFacts; states: StateConnectedness[] } {
    const system = systemAt(moment);
    const facts = directed.directedFacts(system);
    return { system, facts, states: directed.directedConnectedness(system, { epsilon }) };
  },
  /** The boxes of the shape at even moments, both ends included; null where it has no attractor. */
  boxes: (_context: Context, { way, looks }: { way: Way; looks: number }): (Box | null)[] =>
    Array.from({ length: looks }, (_, i) => {
      try {
        return boxOf(systemAt({ ...way, t: i / (looks - 1) }));
      } catch {
        return null;
      }
    }),
  /** Where the morph holds together over (u, v), coarse first. */
  async locus(context: Context<LocusSoFar>, { from, to, ...way }: Way): Promise<LocusSoFar> {
    const { size } = COARSE;
    const options = { ...way, width: size, height: size, epsilon: EPSILON };
    const grid = new directed.DirectedLocus(from, to, options);
    try {
      return await fillLocus(context, COARSE, (r0, r1, stride) => grid.run(r0, r1, stride));
    } finally {
      grid.free();
    }
  },
  match: (_context: Context, { from, to }: Pick<Way, "from" | "to">): DirectedMatch =>
    directed.matchDirected(from, to),
};

export type Tasks = typeof tasks;
