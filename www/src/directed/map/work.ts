/** Where the morph of two graph-directed shapes holds together, as far as it is known. */
import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { directedWay } from "#document/directed/directed";
import { wordsOf } from "#document/notice";
import { directedTask } from "#workers/directed/client";
import type { Way } from "#workers/directed/moment";
import { isStopped, Latest } from "#workers/lanes/latest";
import type { LocusSoFar } from "#workers/lanes/locus-fill";

interface Found {
  way: Way;
  locus: LocusSoFar;
}

const found = signal<Found | null>(null);

/** That of the morph before stays until there is something of the next. */
export const field: ReadonlySignal<Found | null> = found;
export const problem = signal<string | null>(null);

/** While the hand still changes a shape nothing is begun. */
const REST_MS = 150;

/** Keeps it up to date. Returns the end of it. */
export function watchLocus(): () => void {
  const latest = new Latest();
  const stop = effect(() => {
    const way = directedWay.value;
    return untracked(() => {
      latest.stop();
      problem.value = null;
      if (!way) {
        found.value = null;
        return undefined;
      }
      // It was whole before the panel was closed.
      if (found.peek()?.way === way && found.peek()?.locus.progress === 1) return undefined;
      const timer = setTimeout(() => void fill(way, latest.begin()), REST_MS);
      return () => clearTimeout(timer);
    });
  });
  return () => {
    stop();
    latest.stop();
  };
}

async function fill(way: Way, signal: AbortSignal): Promise<void> {
  const take = (locus: LocusSoFar) => {
    if (!signal.aborted) found.value = { way, locus };
  };
  try {
    take(await directedTask("locus", way, { signal, onProgress: take, lane: 3 }));
  } catch (thrown) {
    if (!signal.aborted && !isStopped(thrown)) problem.value = wordsOf(thrown);
  }
}
