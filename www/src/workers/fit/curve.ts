/** From an outline to closed curves, and what they are compared with. Outlines are x0, y0, x1, y1, .. with y up. */
import type { Curve } from "#wasm/api";
import type { Collage, CollageOptions, FitFigures, MeasuredCurve, PreparedOutline } from "#wasm/fit";
import type { Context } from "./context";

export type { Collage, CollageOptions, FitFigures, MeasuredCurve, PreparedOutline } from "#wasm/fit";

export type Grown = "sugar-maple" | "white-oak" | "island" | "noisy";
export type FitStage = "straight" | "copies" | "trade" | "polish";

/** A fit that is under way. */
export interface Reached {
  curve: Curve;
  /** A polyline of it. */
  points: Float64Array<ArrayBuffer>;
  stage: FitStage;
  /** How much is done: 0 to 1. */
  share: number;
  /** In percent of the diagonal; null where it has not been measured yet. */
  rms: number | null;
}

export type Method = "split" | "squares" | "fourier" | "bezier" | "collage";

export interface Rival {
  method: Method;
  numbers: number;
  points: Float64Array<ArrayBuffer>;
  figures: FitFigures;
}

/** Ways to spend bytes, each coded as well as the fit. */
export type ByteMethod = "squares" | "bezier" | "fourier";

/** A curve of corners and parabolas within so many bytes, under way. */
export interface SplineReached {
  word: string;
  points: Float64Array<ArrayBuffer>;
  share: number;
  rms: number;
}

/** The same when it is done. */
export interface SplineMeasured {
  /** It packed, in letters. */
  word: string;
  bytes: Uint8Array<ArrayBuffer>;
  corners: number;
  bends: number;
  /** A polyline of it. */
  points: Float64Array<ArrayBuffer>;
  figures: FitFigures;
}

export interface ByteRival {
  method: ByteMethod;
  points: Float64Array<ArrayBuffer>;
  rms: number;
}

/** How long it goes on between two breaths, and between two words of what has been reached. */
const SLICE_MS = 40;
const TELL_MS = 120;

type Plain = Context<never>;

export const curveTasks = {
  /** An outline grown by program. */
  grow(
    { fit, transfer }: Plain,
    { kind, seed }: { kind: Grown | "maple"; seed: number },
  ): Float64Array<ArrayBuffer> {
    const points = fit.grownOutline(kind, seed);
    transfer(points.buffer);
    return points;
  },

  /** What is fitted of points: counter-clockwise, smoothed by 0 to 1, and no more points than are seen. */
  prepare({ fit, transfer }: Plain, args: { points: Float64Array; smoothing: number }): PreparedOutline {
    const prepared = fit.prepareOutline(args.points, args.smoothing);
    transfer(prepared.points.buffer);
    return prepared;
  },

  /** Feature points in order, by polyline splitting. */
  features({ fit }: Plain, args: { points: Float64Array; count: number }): Float64Array<ArrayBuffer> {
    return fit.featurePoints(args.points, args.count);
  },

  /** Fits a closed curve; what it tells on the way is each time the best so far. */
  async fitCurve(
    { fit, progress, breathe }: Context<Reached>,
    { points, numbers }: { points: Float64Array; numbers: number },
  ): Promise<MeasuredCurve> {
    const handle = new fit.CurveFit(points, numbers);
    const tell = (state: Omit<Reached, "curve" | "points">) => {
      const reached = { ...handle.best(), ...state };
      progress(reached, [reached.points.buffer]);
    };
    try {
      // There is one from the start on, and a first step of many numbers takes its time.
      tell({ stage: "straight", share: 0, rms: null });
      let told = Number.NEGATIVE_INFINITY;
      for (;;) {
        const { done, ...state } = handle.step(SLICE_MS);
        const now = performance.now();
        if (done) return handle.measured();
        if (now - told > TELL_MS) {
          tell({ ...state, stage: state.stage as FitStage });
          told = now;
        }
        await breathe();
      }
    } finally {
      handle.free();
    }
  },

  /** Fits corners and parabolas within so many bytes; what it tells on the way is each time the best so far. */
  async fitWithin(
    { fit, progress, breathe }: Context<SplineReached | { share: number }>,
    { points, bytes }: { points: Float64Array; bytes: number },
  ): Promise<SplineMeasured> {
    const handle = new fit.SplineFit(points, bytes);
    try {
      let told = Number.NEGATIVE_INFINITY;
      let last = "";
      for (;;) {
        const { done, share } = handle.step(SLICE_MS);
        const now = performance.now();
        if (done) return handle.measured() as SplineMeasured;
        if (now - told > TELL_MS) {
          const best = handle.best() as Omit<SplineReached, "share"> | undefined;
          if (best && best.word !== last) progress({ ...best, share }, [best.points.buffer]);
          else progress({ share });
          last = best?.word ?? last;
          told = now;
        }
        await breathe();
      }
    } finally {
      handle.free();
    }
  },

  /** How near a curve of corners and parabolas is to an outline. */
  measureSpline({ fit }: Plain, args: { points: Float64Array; word: string }): SplineMeasured {
    return fit.measureSpline(args.points, args.word) as SplineMeasured;
  },

  /** Other ways to spend so many bytes: null where nothing fits into them. */
  rivalWithin(
    { fit }: Plain,
    { points, method, bytes }: { points: Float64Array; method: ByteMethod; bytes: number },
  ): ByteRival | null {
    const got = fit.rivalWithin(points, method, bytes);
    return got ? { method, ...(got as Omit<ByteRival, "method">) } : null;
  },

  /** How near a curve is to an outline. */
  measure({ fit }: Plain, args: { points: Float64Array; curve: Curve }): MeasuredCurve {
    return fit.measureCurve(args.points, args.curve);
  },

  /** Other ways to spend as many numbers, each told when it is there. */
  async rivals(
    { fit, progress, breathe }: Context<Rival>,
    { points, numbers, methods }: { points: Float64Array; numbers: number; methods: readonly Method[] },
  ): Promise<null> {
    for (const method of methods) {
      try {
        progress({ method, ...fit.rivalFit(points, method, numbers) });
      } catch (problem) {
        // A method that needs more points than there are is left out of the comparison.
        if (problem instanceof WebAssembly.RuntimeError) throw problem;
      }
      await breathe();
    }
    return null;
  },

  /** The paper's own fit. */
  collage({ fit }: Plain, args: { points: Float64Array; options: CollageOptions }): Collage {
    return fit.collageFit(args.points, args.options);
  },
};
