/** What is measured: a series or a profile, and the feature points that are taken of it. */

import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { changeFit } from "#document/fit";
import { announce, notify, wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import type { FeatureSets } from "#workers/fit/hough";
import type { OpenedSeries } from "#workers/fit/trace-types";
import { isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { isFirst } from "./document";
import { EXAMPLES, type Example } from "./examples";

export interface Series {
  name: string;
  /** t0, x0, t1, x1, .., t growing. */
  points: Float64Array;
  /** The example that it is. */
  example?: string;
}

export const series = signal<Series | null>(null);

/** Something is measured and nothing was made yet: Figure 1 of the paper, of other units, would be in the way. */
export const unmade: ReadonlySignal<boolean> = computed(() => isFirst.value && series.value !== null);

/** Coarse and fine feature points. Maps that halve are best seen by halves of halves, those that third by thirds. */
export const COUNTS = [
  { id: "halves", label: messages.n65And129, features: [65, 129], description: messages.halvesHalves2K },
  { id: "thirds", label: messages.n55And163, features: [55, 163], description: messages.thirdsThirds23 },
  { id: "few", label: messages.n33And65, features: [33, 65], description: messages.fewDoneInInstant },
] as const;

export type CountId = (typeof COUNTS)[number]["id"];

export const counts = signal<CountId>("halves");
export const smoothing = signal(0);
/** The largest smoothing that the slider gives, in parts of the interval. */
export const MOST_SMOOTHING = 0.02;

const featureCounts: ReadonlySignal<readonly [number, number]> = computed(
  () => COUNTS.find(({ id }) => id === counts.value)?.features ?? [65, 129],
);

/** The feature points as they are now. */
export const sets = signal<(FeatureSets & { of: Series; smoothing: number }) | null>(null);

let asked: AbortController | null = null;

/** Takes feature points anew. Resolves to null where something else was asked for meanwhile. */
export async function takeFeatures(): Promise<FeatureSets | null> {
  const of = series.peek();
  if (!of) return null;
  asked?.abort();
  const mine = new AbortController();
  asked = mine;
  const [coarse, fine] = featureCounts.peek();
  const args = { points: of.points, coarse, fine, smoothing: smoothing.peek() };
  const got = await fitTask("seriesFeatures", args, { signal: mine.signal });
  if (mine.signal.aborted) return null;
  sets.value = { ...got, of, smoothing: args.smoothing };
  return got;
}

/** Takes another series. */
export function takeSeries(
  given: Pick<OpenedSeries, "name" | "points"> & Partial<OpenedSeries>,
  example?: Example,
): void {
  batch(() => {
    series.value = {
      name: given.name,
      points: given.points,
      ...(example ? { example: example.id } : {}),
    };
    sets.value = null;
    counts.value = example
      ? (COUNTS.find(({ features }) => features[1] === example.features[1])?.id ?? "halves")
      : suited(given.points.length / 2);
    smoothing.value = example?.smoothing ?? 0;
  });
  changeFit((fit) => (fit.mode === "graph" ? fit : { ...fit, mode: "graph" }));
  for (const warning of given.warnings ?? []) notify({ kind: "info", text: warning.message });
  announce(messages.seriesOnStage(given.name, given.points.length / 2));
  takeFeatures().catch((problem: unknown) => {
    if (!isStopped(problem)) notify({ kind: "error", text: wordsOf(problem) });
  });
}

/** Feature points that are points of the series, where it has as many as one of the sets. */
function suited(count: number): CountId {
  const intervals = count - 1;
  const fits = COUNTS.find(({ features }) => intervals >= 64 && intervals % (features[1] - 1) === 0);
  return fits?.id ?? (count < 65 ? "few" : "halves");
}

export function takeExample(id: string): void {
  const example = EXAMPLES.find((one) => one.id === id);
  if (example) takeSeries({ name: example.name, points: example.make() }, example);
}

export const reading = signal<string | null>(null);
/** Why the last file could not be taken. */
export const fileProblem = signal<string | null>(null);

/** Reads a file. What was there stays until the new one is read. */
export async function takeFile(file: File): Promise<void> {
  reading.value = file.name;
  fileProblem.value = null;
  try {
    const got = await readSeries(file);
    if (reading.peek() === file.name) takeSeries(got);
  } catch (problem) {
    fileProblem.value = wordsOf(problem);
    announce(wordsOf(problem));
  } finally {
    if (reading.peek() === file.name) reading.value = null;
  }
}

/** Whether a file is numbers in rows, by its name. */
export function isTable(name: string): boolean {
  return /\.(csv|tsv|txt|dat|json|geojson)$/i.test(name);
}

/** Reads a series of a file, in the worker that reads files. Throws an error that says what to try. */
export async function readSeries(file: File): Promise<OpenedSeries> {
  const got = await fitTask("openFile", { file, name: file.name, as: "series" }, { lane: 1 });
  if (got.kind === "series") return got;
  if (got.kind === "picture") got.bitmap.close();
  const what = got.kind === "picture" ? messages.picture : messages.outline2;
  throw {
    code: "no-series",
    message: messages.notSeries(file.name, what),
  };
}
