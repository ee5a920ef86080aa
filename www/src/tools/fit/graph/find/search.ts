/** Finding the maps that a graph is made of: both passes in both workers, what they found, and what is made of it. */
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { announce, wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import type {
  Assembled,
  Counting,
  FeatureSets,
  HoughCluster,
  HoughClusters,
  HoughOptions,
} from "#workers/fit/hough";
import { isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { take } from "../model/document";
import { offWords } from "../model/graph-text";
import { short } from "../model/model";
import { type Series, series, takeFeatures } from "../model/series";
import { TABLE_3 } from "../printed";

const LANES = [0, 1] as const;

export interface Running {
  phase: "first" | "second" | "naming";
  /** Of the whole search. */
  share: number;
  votes: number;
}

/** What was found, and in what. */
export interface Search {
  of: Series;
  sets: FeatureSets;
  options: HoughOptions;
  clusters: HoughClusters;
  votes: number;
  /** Hits at a * 128 + c, the most of any b. */
  plane: Uint32Array;
  /** Milliseconds. */
  took: number;
}

export const reflected = signal(true);
export const running = signal<Running | null>(null);
/** What has been counted so far, while it counts. */
export const live = signal<Uint32Array | null>(null);
export const search = signal<Search | null>(null);
export const problem = signal<string | null>(null);

/** Picks by hand: which clusters, with their domains. */
export interface Pick {
  cluster: number;
  map: HoughCluster["map"];
  domain: [number, number];
}
export const picks = signal<readonly Pick[]>([]);
/** The cluster that is looked at. */
export const chosen = signal<number | null>(null);
/** Whether its map is shown on the stage. */
export const copying = signal(true);
/** Whether ends of picked pieces are moved so that they meet. */
export const tied = signal(true);
/** How far off what is put together may be, in heights of the graph. */
export const tolerance = signal(0.02);
export const LEAST_TOLERANCE = 0.001;
export const MOST_TOLERANCE = 0.2;
export const assembling = signal(false);
/** How the graph on the stage was put together, as long as it is that graph. */
export const assembled = signal<Assembled | null>(null);

export const found: ReadonlySignal<readonly HoughCluster[]> = computed(
  () => search.value?.clusters.found ?? [],
);

/** Whether what was found belongs to what is on the stage. */
export const current: ReadonlySignal<boolean> = computed(() => search.value?.of === series.value);

let asked: AbortController | null = null;

/** Searches anew. What was found before stays until this has come to its end. */
export async function find(): Promise<void> {
  const of = series.peek();
  if (!of) return;
  cancel();
  const mine = new AbortController();
  const { signal: stop } = mine;
  asked = mine;
  const options: HoughOptions = { reflected: reflected.peek() };
  batch(() => {
    running.value = { phase: "first", share: 0, votes: 0 };
    problem.value = null;
    live.value = null;
  });
  const began = performance.now();
  try {
    const sets = await takeFeatures();
    if (!sets || stop.aborted) return;
    const shares = [0, 0];
    const votes = [0, 0];
    const planes: (Uint32Array | null)[] = [null, null];
    const tell = (lane: number, phase: Running["phase"], { share, votes: count, plane }: Counting) => {
      if (stop.aborted) return;
      shares[lane] = share;
      if (phase === "first") votes[lane] = count;
      if (plane) planes[lane] = plane;
      const least = Math.min(...shares);
      batch(() => {
        running.value = {
          phase,
          share: phase === "first" ? 0.5 * least : 0.5 + 0.5 * least,
          votes: votes.reduce((sum, n) => sum + n, 0),
        };
        if (plane) live.value = sum(planes);
      });
    };
    const parts = LANES.length;
    const counted = await Promise.all(
      LANES.map((lane) =>
        fitTask(
          "houghFirst",
          { sets, options, part: lane, parts },
          { lane, signal: stop, onProgress: (state) => tell(lane, "first", state) },
        ),
      ),
    );
    const others = counted.map(({ counts }) => counts).filter((counts) => counts !== null);
    const { cells, plane } = await fitTask(
      "houghCells",
      { others, parts },
      { lane: 0, signal: stop, transfer: others.map(({ buffer }) => buffer) },
    );
    if (stop.aborted) return;
    live.value = plane;
    shares.fill(0);
    const peaks = await Promise.all(
      LANES.map((lane) =>
        fitTask(
          "houghSecond",
          { sets, options, cells: cells[lane] ?? new Uint32Array(0) },
          { lane, signal: stop, onProgress: (state) => tell(lane, "second", state) },
        ),
      ),
    );
    if (stop.aborted) return;
    const all = counted.reduce((sum_, part) => sum_ + part.votes, 0);
    running.value = { phase: "naming", share: 1, votes: all };
    const clusters = await fitTask("houghClusters", { sets, options, peaks }, { lane: 0, signal: stop });
    if (stop.aborted) return;
    batch(() => {
      search.value = { of, sets, options, clusters, votes: all, plane, took: performance.now() - began };
      running.value = null;
      live.value = null;
      picks.value = [];
      chosen.value = firstLook(clusters.found);
      copying.value = true;
    });
    const maps = clusters.found.filter(({ kind }) => kind === "map").length;
    announce(messages.clustersFound(clusters.found.length, maps));
  } catch (wrong) {
    if (!stop.aborted && !isStopped(wrong)) {
      batch(() => {
        running.value = null;
        live.value = null;
        problem.value = wordsOf(wrong);
      });
    }
  }
}

/** What is looked at first: the strongest map, else the strongest echo. Clutter, which fits anything, never. */
export function firstLook(clusters: readonly HoughCluster[]): number | null {
  for (const wanted of ["map", "echo"] as const) {
    const index = clusters.findIndex(({ kind }) => kind === wanted);
    if (index >= 0) return index;
  }
  return null;
}

function sum(planes: readonly (Uint32Array | null)[]): Uint32Array | null {
  const [first, ...rest] = planes.filter((plane) => plane !== null);
  if (!first) return null;
  // Shares may have their most at another b: near enough for a look.
  return rest.reduce((all, plane) => all.map((n, i) => n + (plane[i] ?? 0)), first);
}

/** Stops the search; what was found before stays. */
export function cancel(): void {
  if (!asked) return;
  asked.abort();
  asked = null;
  if (!running.peek()) return;
  batch(() => {
    running.value = null;
    live.value = null;
  });
  announce(messages.stopped);
}

/** Looks at a cluster: its map is shown on the graph. */
export function choose(cluster: number): void {
  chosen.value = cluster;
  copying.value = true;
}

export function isPicked(cluster: number): boolean {
  return picks.value.some((pick) => pick.cluster === cluster);
}

/** Puts a cluster's map into the hand-picked list, or takes it out. */
export function togglePick(cluster: number): void {
  const now = picks.peek();
  if (now.some((pick) => pick.cluster === cluster)) {
    picks.value = now.filter((pick) => pick.cluster !== cluster);
    return;
  }
  const one = found.peek()[cluster];
  const fine = search.peek()?.sets.fine;
  if (!one || !fine) return;
  const all: [number, number] = [fine[0] ?? 0, fine[fine.length - 2] ?? 1];
  picks.value = [...now, { cluster, map: mapOf(one), domain: one.candidate?.domain ?? all }];
}

export function setDomain(cluster: number, domain: [number, number]): void {
  picks.value = picks.peek().map((pick) => (pick.cluster === cluster ? { ...pick, domain } : pick));
}

/** The map of a cluster: refined where it holds somewhere, else the middle of its bin. */
export function mapOf(cluster: HoughCluster): HoughCluster["map"] {
  return cluster.candidate?.map ?? cluster.map;
}

/** Puts a whole function together: of the picks, or of all candidates by itself. */
export async function assemble(by: "hand" | "itself"): Promise<void> {
  const now = search.peek();
  if (!now || assembling.peek()) return;
  assembling.value = true;
  problem.value = null;
  try {
    const { sets } = now;
    const got =
      by === "itself"
        ? await fitTask("houghAssemble", {
            sets,
            candidates: candidatesOf(now),
            tolerance: tolerance.peek(),
          })
        : await fitTask("houghPicked", {
            sets,
            picks: picks.peek().map(({ map, domain }) => ({ map, domain })),
            tied: tied.peek(),
          });
    // Another search has come to its end meanwhile.
    if (search.peek() !== now) return;
    const whole = { ...got, graph: short(got.graph) };
    take(whole.graph);
    assembled.value = whole;
    // Now the whole is looked at.
    copying.value = false;
    const pieces = got.graph.pieces.length;
    announce(messages.assembledFrom(pieces, offWords(got)));
  } catch (wrong) {
    if (!isStopped(wrong)) problem.value = wordsOf(wrong);
  } finally {
    assembling.value = false;
  }
}

function candidatesOf({ clusters }: Search) {
  return clusters.found.map(({ candidate }) => candidate).filter((candidate) => candidate !== null);
}

/** How far from a map of Table 3 the middle of a cluster's bin may lie to be that map: a bin. */
const SAME_MAP = [0.016, 0.047, 0.016, 0.016, 0.047] as const;

/** The clusters that are the seven maps of Table 3, with the maps and domains that the authors refined them to. */
export function tableThree(clusters: readonly HoughCluster[]): Pick[] {
  return TABLE_3.pieces.flatMap(({ map, domain }) => {
    const off = (cluster: HoughCluster) =>
      Math.max(...cluster.map.map((x, i) => Math.abs(x - (map[i] ?? 0)) / (SAME_MAP[i] ?? 1)));
    let best = -1;
    for (const [i, cluster] of clusters.entries()) {
      const before = clusters[best];
      if (off(cluster) <= 1 && (!before || off(cluster) < off(before))) best = i;
    }
    return best < 0 ? [] : [{ cluster: best, map: [...map], domain: [...domain] }];
  });
}

/** Smoothing and feature points changed: what was found is of other points. */
export function featuresChanged(): void {
  takeFeatures().catch((wrong: unknown) => {
    if (!isStopped(wrong)) problem.value = wordsOf(wrong);
  });
}
