import { useEffect, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import type { Intersection3, MapRow3 } from "#wasm/api";
import { isStopped } from "#workers/lanes/latest";
import { spaceTask } from "#workers/space/client";

export interface Met {
  of: { first: MapRow3[]; second: MapRow3[] };
  /** Null where the construction cannot be done; `problem` then says why. */
  found: Intersection3 | null;
  problem: string | null;
}

const POINTS = 30_000;

/** Where two shapes meet, worked out aside. What was found last stays until there is something new. */
export function useMeet(first: MapRow3[], second: MapRow3[]): Met | null {
  const [met, setMet] = useState<Met | null>(null);
  useEffect(() => {
    const end = new AbortController();
    const of = { first, second };
    spaceTask("meet", { ...of, points: POINTS }, { signal: end.signal }).then(
      (found) => {
        if (!end.signal.aborted) setMet({ of, found, problem: null });
      },
      (problem) => {
        if (!end.signal.aborted && !isStopped(problem))
          setMet({ of, found: null, problem: wordsOf(problem) });
      },
    );
    return () => end.abort();
  }, [first, second]);
  return met;
}
