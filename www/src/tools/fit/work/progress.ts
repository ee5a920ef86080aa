/** How the fit under way is getting on, of whichever kind it is. */
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { wordsOf } from "#document/notice";
import type { FitStage } from "#workers/fit/curve";

export interface Running {
  stage: FitStage | "begin";
  share: number;
  /** Of the best so far, in percent of the diagonal. */
  rms?: number | null;
}

/** Null while nothing is under way. */
export const running = signal<Running | null>(null);
/** Whether it was stopped before its end. */
export const cancelled = signal(false);
export const problem = signal<string | null>(null);
/** Whether a first fit is still to come: none is where it failed or was stopped. */
export const awaited: ReadonlySignal<boolean> = computed(() => problem.value === null && !cancelled.value);
/** Whether the tool is open: the document may be another one when it is not. */
export const watched = signal(false);

export function fail(wrong: unknown): void {
  batch(() => {
    running.value = null;
    problem.value = wordsOf(wrong);
  });
}
