/** Votes for the maps that a graph is made of, counted in both workers of the fit. */
import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import type { Counting, FeatureSets, HoughClusters } from "#workers/fit/hough";

export interface Election {
  /** Under which its outcome is kept, for whoever comes back. */
  name: string;
  sets: FeatureSets;
  /** Whether mirrored maps are tried, too. */
  reflected: boolean;
}

export interface Outcome {
  clusters: HoughClusters;
  votes: number;
  /** Hits at a * 128 + c, the most of any b. */
  plane: Uint32Array;
  seconds: number;
}

export interface Voting {
  state: "running" | "stopped" | "done" | "failed";
  /** 0 to 1, of both passes. */
  share: number;
  votes: number;
  plane: Uint32Array | null;
  outcome: Outcome | null;
  problem: string;
  stop: () => void;
  again: () => void;
}

type Now = Omit<Voting, "stop" | "again">;

const LANES = [0, 1] as const;
const kept = new Map<string, Outcome>();
const BEGIN: Now = { state: "running", share: 0, votes: 0, plane: null, outcome: null, problem: "" };

/** Counts as soon as it is shown, and whenever `election` is another object; `again` counts anew. */
export function useVotes(election: Election): Voting {
  const [now, setNow] = useState<Now>(BEGIN);
  const [round, setRound] = useState(0);
  const stopper = useRef<AbortController | null>(null);
  useEffect(() => {
    const before = round === 0 ? kept.get(election.name) : undefined;
    if (before) {
      setNow(doneOf(before));
      return;
    }
    const stop = new AbortController();
    stopper.current = stop;
    setNow(BEGIN);
    count(election, stop.signal, (told) => setNow((last) => ({ ...last, ...told }))).then(
      (outcome) => {
        kept.set(election.name, outcome);
        setNow(doneOf(outcome));
      },
      (problem) => {
        if (stop.signal.aborted) setNow((last) => ({ ...last, state: "stopped" }));
        else {
          stop.abort();
          setNow((last) => ({ ...last, state: "failed", problem: wordsOf(problem) }));
        }
      },
    );
    return () => stop.abort();
  }, [election, round]);
  return { ...now, stop: () => stopper.current?.abort(), again: () => setRound(round + 1) };
}

function doneOf(outcome: Outcome): Now {
  const { votes, plane } = outcome;
  return { ...BEGIN, state: "done", share: 1, votes, plane, outcome };
}

async function count(
  { sets, reflected }: Election,
  signal: AbortSignal,
  tell: (told: Partial<Now>) => void,
): Promise<Outcome> {
  const began = performance.now();
  const options = { reflected };
  const parts = LANES.length;
  const states: Counting[] = LANES.map(() => ({ share: 0, votes: 0 }));
  const planes: (Uint32Array | undefined)[] = LANES.map(() => undefined);
  const hear = (lane: number, pass: number) => (state: Counting) => {
    if (signal.aborted) return;
    states[lane] = state;
    if (state.plane) planes[lane] = state.plane;
    const share = 0.5 * pass + 0.5 * Math.min(...states.map((one) => one.share));
    const votes = states.reduce((sum, one) => sum + one.votes, 0);
    tell(pass === 0 ? { share, votes, plane: added(planes) } : { share });
  };
  const counted = await Promise.all(
    LANES.map((lane) =>
      fitTask(
        "houghFirst",
        { sets, options, part: lane, parts },
        { lane, signal, onProgress: hear(lane, 0) },
      ),
    ),
  );
  const votes = counted.reduce((sum, part) => sum + part.votes, 0);
  const others = counted.flatMap(({ counts }) => (counts ? [counts] : []));
  const { cells, plane } = await fitTask(
    "houghCells",
    { others, parts },
    { lane: 0, signal, transfer: others.map(({ buffer }) => buffer) },
  );
  tell({ votes, plane });
  states.fill({ share: 0, votes: 0 });
  const peaks = await Promise.all(
    LANES.map((lane) =>
      fitTask(
        "houghSecond",
        { sets, options, cells: cells[lane] ?? new Uint32Array(0) },
        { lane, signal, onProgress: hear(lane, 1) },
      ),
    ),
  );
  const clusters = await fitTask("houghClusters", { sets, options, peaks }, { lane: 0, signal });
  return { clusters, votes, plane, seconds: (performance.now() - began) / 1000 };
}

/** Sums of counts, where there are any. */
export function added(lists: readonly (Uint32Array | undefined)[]): Uint32Array | null {
  const there = lists.filter((list) => list !== undefined);
  const first = there[0];
  if (!first) return null;
  const all = first.slice();
  for (const list of there.slice(1)) {
    for (let i = 0; i < all.length; i++) all[i] = (all[i] ?? 0) + (list[i] ?? 0);
  }
  return all;
}
