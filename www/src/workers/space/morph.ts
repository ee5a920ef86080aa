import type { Told } from "#format/verdict";
import { uvAt } from "#geometry/path";
import type {
  Connectedness3,
  Intersection3,
  MapRow3,
  MorphOptions,
  PathCheck,
  PathPlan,
  PathPoint,
} from "#wasm/api";
import { solid } from "#wasm/space";
import { BREATH, EPSILON, FINE, fillLocus, type LocusSoFar } from "../lanes/locus-fill";
import type { Context } from "../lanes/task";

/** All that a morph hangs on besides where on it one is. */
export interface MorphInputs {
  from: MapRow3[];
  to: MapRow3[];
  options: MorphOptions;
}

/** A path, and what was found along it. */
export interface PathFound {
  plan: PathPlan;
  check: PathCheck;
  /** How much of the search is done: 1 where it is this one. */
  share: number;
}

/** A path with what is said of its moments, evenly spaced, and of the points between its ends. */
export interface PathTold extends PathCheck {
  told: Told[];
  ways: Told[];
}

/**
 * Samples a side of the locus that a path is looked for in: the next only where the one before has found none that
 * holds.
 */
const SIDES = [13, 25, 49] as const;
/** Moments of a path that are looked at. */
const MOMENTS = 401;
/** Moments of which all is told that is known. */
const TOLD = 201;

export const morphTasks = {
  /** Where a morph holds together, coarse first. */
  async morphLocus(context: Context<LocusSoFar>, { from, to, options }: MorphInputs): Promise<LocusSoFar> {
    const grid = new solid.SpaceLocus(from, to, {
      ...options,
      width: FINE.size,
      height: FINE.size,
      epsilon: EPSILON,
    });
    try {
      return await fillLocus(context, FINE, (r0, r1, stride) => grid.run(r0, r1, stride));
    } finally {
      grid.free();
    }
  },

  /** The path whose widest gap is the narrowest. What is found on the way is told. */
  async morphPath(
    { progress, breathe }: Context<PathFound>,
    { from, to, options }: MorphInputs,
  ): Promise<PathFound> {
    let best: PathFound | null = null;
    for (const [i, size] of SIDES.entries()) {
      const plan = solid.findPath3(from, to, { ...options, epsilon: EPSILON, size });
      await breathe();
      const check = checked({ from, to, options }, plan.points);
      const found: PathFound = { plan, check, share: sharePath(i) };
      if (!best || check.gap < best.check.gap || (i === 1 && check.gap === best.check.gap)) best = found;
      // The coarsest is only a first answer: a finer one keeps farther from what breaks.
      if (i > 0 && best.check.holds) break;
      if (i < SIDES.length - 1) progress({ ...best, share: found.share });
      await breathe();
    }
    return { ...(best as PathFound), share: 1 };
  },

  /** Where a path breaks, and all that is known at its moments. */
  async morphCheck(
    { breathe }: Context,
    { points, ...inputs }: MorphInputs & { points: PathPoint[] },
  ): Promise<PathTold> {
    const even = Array.from({ length: TOLD }, (_, i) => uvAt(points, i / (TOLD - 1)));
    const told: Told[] = [];
    let last = performance.now();
    for (const at of [...even, ...points.slice(1, -1)]) {
      told.push(toldThere(inputs, at));
      if (performance.now() - last < BREATH) continue;
      await breathe();
      last = performance.now();
    }
    return { ...checked(inputs, points), told: told.slice(0, TOLD), ways: told.slice(TOLD) };
  },

  /** Whether a shape is in one piece. */
  holds(_: Context, { maps }: { maps: MapRow3[] }): Connectedness3 {
    return solid.connectedness3(maps, { epsilon: EPSILON });
  },

  /** Where two shapes meet whose maps share one linear part. */
  meet(
    { transfer }: Context,
    { first, second, points }: { first: MapRow3[]; second: MapRow3[]; points: number },
  ): Intersection3 {
    const found = solid.intersection3(first, second, { points });
    transfer(found.points.buffer as ArrayBuffer);
    return found;
  },
};

/** The full answer: the one that the picture has there. */
function toldThere({ from, to, options }: MorphInputs, [u, v, w = 0]: PathPoint): Told {
  const maps = solid.interpolate3(from, to, { ...options, u, v, w });
  const { verdict, gap, diameter } = solid.connectedness3(maps, { epsilon: EPSILON });
  return { verdict, gap, diameter };
}

function checked({ from, to, options }: MorphInputs, points: readonly PathPoint[]): PathCheck {
  return solid.checkPath3(from, to, points, { ...options, epsilon: EPSILON, samples: MOMENTS });
}

/** As samples are to be looked at, so is the time. */
function sharePath(i: number): number {
  const cost = (list: readonly number[]) => list.reduce((sum, side) => sum + side * side, 0);
  return cost(SIDES.slice(0, i + 1)) / cost(SIDES);
}
