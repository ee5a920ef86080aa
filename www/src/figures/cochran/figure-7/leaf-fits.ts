/** What Figure 7 asks of the workers of the fit. */
import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import type { Collage, MeasuredCurve, Method, Reached, Rival } from "#workers/fit/curve";

/** As the paper has it. */
export const FEATURES = 261;
export const MAPS = [52, 29] as const;
export type Maps = (typeof MAPS)[number];
export interface Leaf {
  points: Float64Array<ArrayBuffer>;
  features: Float64Array<ArrayBuffer>;
}

/** The kind of leaf that stands for the paper's: "the Maple leaf shown in Figure 7". */
export const KIND = "sugar-maple";

/** A leaf of our own, with its feature points; null until it has grown. */
export function useLeaf(seed: number): { leaf: Leaf | null; problem: string | null } {
  const [state, setState] = useState<{ seed: number; leaf: Leaf | null; problem: string | null }>({
    seed,
    leaf: null,
    problem: null,
  });
  useEffect(() => {
    const stop = new AbortController();
    const grow = async () => {
      const { signal } = stop;
      const grown = await fitTask("grow", { kind: KIND, seed }, { signal });
      const { points } = await fitTask("prepare", { points: grown, smoothing: 0 }, { signal });
      const features = await fitTask("features", { points, count: FEATURES }, { signal });
      setState({ seed, leaf: { points, features }, problem: null });
    };
    grow().catch((problem) => {
      if (!stop.signal.aborted) setState({ seed, leaf: null, problem: wordsOf(problem) });
    });
    return () => stop.abort();
  }, [seed]);
  return state.seed === seed ? state : { leaf: null, problem: null };
}

/** The paper's fits of a leaf, with 52 and with 29 maps; both null until they are there. */
export function useCollages(leaf: Leaf | null, tied: boolean, separable: boolean) {
  const [fits, setFits] = useState<{ leaf: Leaf; tied: boolean; separable: boolean; fits: Collage[] } | null>(
    null,
  );
  useEffect(() => {
    if (!leaf) return;
    const stop = new AbortController();
    const one = (maps: number) =>
      fitTask(
        "collage",
        { points: leaf.points, options: { maps, features: FEATURES, separable, tied, partitioned: false } },
        { signal: stop.signal },
      );
    Promise.all(MAPS.map(one)).then(
      (done) => setFits({ leaf, tied, separable, fits: done }),
      () => {},
    );
    return () => stop.abort();
  }, [leaf, tied, separable]);
  const current = fits?.leaf === leaf && fits?.tied === tied && fits.separable === separable;
  return current ? fits.fits : null;
}

export interface CurveState {
  state: "running" | "stopped" | "done" | "failed";
  /** The best so far. */
  reached: Reached | null;
  done: MeasuredCurve | null;
  /** Plain polylines of as many numbers. */
  rivals: readonly Rival[];
  problem: string;
  stop: () => void;
  again: () => void;
}

/** Plain polylines that the curve is compared with. */
const POLYLINES: readonly { method: Method; name: string }[] = [
  { method: "split", name: "Polyline, split" },
  { method: "squares", name: "Polyline, best corners" },
];

/** The polylines by their names, each with its fit once that is there. */
export const polylinesOf = (rivals: readonly Rival[]) =>
  POLYLINES.map(({ method, name }) => ({ name, fit: rivals.find((rival) => rival.method === method) }));

/** Frond's own fit of a leaf with so many numbers, which improves while it is watched. */
export function useCurveFit(leaf: Leaf | null, numbers: number): CurveState {
  const [now, setNow] = useState<Pick<CurveState, "state" | "reached" | "done" | "problem">>(IDLE);
  const [rivals, setRivals] = useState<readonly Rival[]>([]);
  const [round, setRound] = useState(0);
  const stopper = useRef<AbortController | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another round fits anew
  useEffect(() => {
    setNow(IDLE);
    setRivals([]);
    if (!leaf) return;
    const stop = new AbortController();
    const { signal } = stop;
    stopper.current = stop;
    const { points } = leaf;
    let told = Number.NEGATIVE_INFINITY;
    const tell = (reached: Reached) => {
      // The worker says more than needs to be drawn.
      if (performance.now() - told < TELL_MS) return;
      told = performance.now();
      setNow({ ...IDLE, reached });
    };
    fitTask("fitCurve", { points, numbers }, { signal, lane: 1, onProgress: tell }).then(
      (done) => setNow((last) => ({ ...last, state: "done", done })),
      (problem) => {
        const stopped = signal.aborted;
        setNow((last) => ({
          ...last,
          state: stopped ? "stopped" : "failed",
          problem: stopped ? "" : wordsOf(problem),
        }));
      },
    );
    const compared = new AbortController();
    fitTask(
      "rivals",
      { points, numbers, methods: POLYLINES.map(({ method }) => method) },
      { signal: compared.signal, onProgress: (rival) => setRivals((all) => [...all, rival]) },
    ).catch(() => {});
    return () => {
      stop.abort();
      compared.abort();
    };
  }, [leaf, numbers, round]);
  return {
    ...now,
    rivals,
    stop: () => stopper.current?.abort(),
    again: () => setRound(round + 1),
  };
}

const TELL_MS = 250;

const IDLE = { state: "running", reached: null, done: null, problem: "" } as const;
