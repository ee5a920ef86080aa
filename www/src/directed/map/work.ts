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

/** Whether anybody sees the map: it is long work, which is begun for who looks, and then goes on. */
export const inSight = signal(false);

/** Keeps it up to date. Returns the end of it. */
export function watchLocus(): () => void {
  const latest = new Latest();
  let timer: ReturnType<typeof setTimeout> | undefined;
  let begun: Way | null = null;
  const end = () => {
    clearTimeout(timer);
    latest.stop();
    begun = null;
  };
  const stop = effect(() => {
    const way = directedWay.value;
    const seen = inSight.value;
    untracked(() => {
      if (way !== begun) end();
      if (!way) found.value = null;
      const last = found.peek();
      // It may have been whole before the panel was closed.
      if (!way || !seen || begun === way || (last?.way === way && last.locus.progress === 1)) return;
      begun = way;
      problem.value = null;
      timer = setTimeout(() => void fill(way, latest.begin()), REST_MS);
    });
  });
  return () => {
    stop();
    end();
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
