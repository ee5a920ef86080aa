/** The maps that a graph is made of, found by voting. Points are t0, x0, t1, x1, .. */
import type { Graph } from "#wasm/api";
import type { FitModule, GraphMap, HoughCandidate, HoughClusters, HoughOptions } from "#wasm/fit";
import type { Context } from "./context";

export type { HoughCluster, HoughClusters, HoughOptions } from "#wasm/fit";

/** What is counted: domains of coarse feature points, ranges of fine ones. */
export interface FeatureSets {
  coarse: Float64Array;
  fine: Float64Array;
}

export interface Assembled {
  graph: Graph;
  /** Which candidate each piece is, before it was cut finer; null where it is straight. */
  used: (number | null)[];
  meanSquare: number;
  worst: number;
  /** Within a tolerance: how many numbers it is made of, and how many a polyline takes that is as near. */
  numbers?: number;
  polyline?: number;
}

export interface Counting {
  /** 0 to 1, of this pass. */
  share: number;
  votes: number;
  /** Hits so far at a * 128 + c, the most of any b. */
  plane?: Uint32Array<ArrayBuffer>;
}

type FirstPass = InstanceType<FitModule["HoughFirst"]>;
type Counter = Pick<FirstPass, "step">;

type Plain = Context<never>;

/** How long it counts between two breaths, and between two pictures of what has been counted. */
const SLICE_MS = 40;
const TELL_MS = 150;

/** Declared as what may be shared memory; it never is. */
const owned = (counts: Uint32Array) => counts as Uint32Array<ArrayBuffer>;

/** The name under which the first pass of a lane waits for the counts of the other. */
const FIRST = "hough first";

/** Steps to the end. */
async function count(
  counter: Counter,
  { breathe, progress }: Context<Counting>,
  look?: () => Uint32Array<ArrayBuffer>,
): Promise<number> {
  let told = performance.now();
  for (;;) {
    const until = performance.now() + SLICE_MS;
    let state = counter.step();
    while (state.share < 1 && performance.now() < until) state = counter.step();
    if (state.share >= 1) {
      progress(state);
      return state.votes;
    }
    if (performance.now() - told > TELL_MS) {
      const plane = look?.();
      if (plane) progress({ ...state, plane }, [plane.buffer]);
      else progress(state);
      told = performance.now();
    }
    await breathe();
  }
}

function drop(keep: Map<string, unknown>): void {
  (keep.get(FIRST) as FirstPass | undefined)?.free();
  keep.delete(FIRST);
}

export const houghTasks = {
  /** Coarse and fine feature points of a series, smoothed by so many parts of its length. */
  seriesFeatures(
    { fit, transfer }: Plain,
    args: { points: Float64Array; coarse: number; fine: number; smoothing: number },
  ): { coarse: Float64Array<ArrayBuffer>; fine: Float64Array<ArrayBuffer> } {
    const [coarse, fine] = [args.coarse, args.fine].map((n) =>
      fit.seriesFeatures(args.points, n, args.smoothing),
    ) as [Float64Array<ArrayBuffer>, Float64Array<ArrayBuffer>];
    transfer(coarse.buffer, fine.buffer);
    return { coarse, fine };
  },

  /** Counts a share of the first pass. The last share gives its counts away; the first keeps its own. */
  async houghFirst(
    context: Context<Counting>,
    { sets, options, part, parts }: { sets: FeatureSets; options: HoughOptions; part: number; parts: number },
  ): Promise<{ votes: number; counts: Uint32Array<ArrayBuffer> | null }> {
    drop(context.keep);
    const pass = new context.fit.HoughFirst(sets.coarse, sets.fine, options, part, parts);
    let kept = false;
    try {
      const votes = await count(pass, context, () => owned(pass.plane()));
      if (part === 0) {
        context.keep.set(FIRST, pass);
        kept = true;
        return { votes, counts: null };
      }
      const counts = owned(pass.counts());
      context.transfer(counts.buffer);
      return { votes, counts };
    } finally {
      if (!kept) pass.free();
    }
  },

  /** Adds the other shares' counts to what this lane kept, and says which cells each part of the second pass gets. */
  houghCells(
    { keep }: Plain,
    { others, parts }: { others: Uint32Array[]; parts: number },
  ): { cells: Uint32Array<ArrayBuffer>[]; plane: Uint32Array<ArrayBuffer> } {
    const pass = keep.get(FIRST) as FirstPass | undefined;
    if (!pass) throw { code: "lost", message: "What was counted is lost. Count again." };
    try {
      for (const counts of others) pass.add(counts);
      return { cells: pass.promising(parts), plane: owned(pass.plane()) };
    } finally {
      drop(keep);
    }
  },

  /** Counts the second pass for some cells. */
  async houghSecond(
    context: Context<Counting>,
    { sets, options, cells }: { sets: FeatureSets; options: HoughOptions; cells: Uint32Array },
  ): Promise<Float64Array<ArrayBuffer>> {
    const pass = new context.fit.HoughSecond(sets.coarse, sets.fine, options, cells);
    try {
      await count(pass, context);
      const peaks = pass.peaks() as Float64Array<ArrayBuffer>;
      context.transfer(peaks.buffer);
      return peaks;
    } finally {
      pass.free();
    }
  },

  /** Names and refines what all parts found. */
  houghClusters(
    { fit }: Plain,
    { sets, options, peaks }: { sets: FeatureSets; options: HoughOptions; peaks: Float64Array[] },
  ): HoughClusters {
    const all = new Float64Array(peaks.reduce((sum, part) => sum + part.length, 0));
    let from = 0;
    for (const part of peaks) {
      all.set(part, from);
      from += part.length;
    }
    return fit.houghClusters(sets.coarse, sets.fine, options, all);
  },

  /** Where a map holds, and what it is by least squares. */
  houghRefine({ fit }: Plain, { sets, map }: { sets: FeatureSets; map: number[] }): HoughCandidate | null {
    return fit.houghRefine(sets.coarse, sets.fine, Float64Array.from(map));
  },

  /** The shortest function of candidates that is nowhere farther off than a tolerance, in heights of the graph. */
  houghAssemble(
    { fit }: Plain,
    args: { sets: FeatureSets; candidates: HoughCandidate[]; tolerance: number },
  ): Assembled {
    return fit.houghAssemble(args.sets.coarse, args.sets.fine, args.candidates, args.tolerance);
  },

  /** A whole function of maps that were picked with their domains. */
  houghPicked(
    { fit }: Plain,
    args: { sets: FeatureSets; picks: { map: GraphMap; domain: [number, number] }[]; tied: boolean },
  ): Assembled {
    return fit.houghPicked(args.sets.coarse, args.sets.fine, args.picks, args.tied);
  },
};
