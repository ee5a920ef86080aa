/**
 * What is worked out of the morph: where it holds, a path, where that breaks, and whether what is seen is in one piece.
 */
import { batch, computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { wordsOf } from "#document/notice";
import { replace, scene } from "#document/scene";
import { space, spaceFrame, spacePart } from "#document/space/space";
import { pointsOf, thinned, type Uv, uvAt } from "#geometry/path";
import type { Connectedness3, MapRow3, PathPoint, SpaceMorph } from "#wasm/api";
import { solid } from "#wasm/space";
import { InTurn, isStopped, Latest } from "#workers/lanes/latest";
import type { LocusSoFar } from "#workers/lanes/locus-fill";
import { spaceTask } from "#workers/space/client";
import type { MorphInputs, PathFound, PathTold } from "#workers/space/morph";
import { MOST_POINTS, optionsOf, withPath } from "./morph-edits";

export const morph: ReadonlySignal<SpaceMorph | null> = computed(() => space.value?.morph ?? null);

/** The maps of the first object, as the document has them. */
export const from: ReadonlySignal<MapRow3[]> = computed(() => space.value?.objects[0]?.maps ?? []);

/** Whether the two have the same number of maps: else there is no morph, whatever the document says. */
export const matched: ReadonlySignal<boolean> = computed(
  () => morph.value !== null && morph.value.to.maps.length === from.value.length,
);

const goal = computed(() => (matched.value ? morph.value?.to.maps : undefined));
/** Which map each becomes where pieces are to travel, turn and stretch least in all. */
export const nearest: ReadonlySignal<number[]> = computed(() =>
  goal.value ? solid.correspondence3(from.value, goal.value) : [],
);

/** For each map that turns by half a turn, the whole turns that make it the other half turn; 0 for all others. */
export const halfTurns: ReadonlySignal<number[]> = computed(() => {
  const now = morph.value;
  if (!now || !goal.value) return [];
  return solid.halfTurns3(from.value, goal.value, optionsOf(now, from.value.length));
});

/** What a morph hangs on, as text: it stays the same text while only the moment changes. */
const asked: ReadonlySignal<string> = computed(() => {
  const now = morph.value;
  if (!now || !matched.value) return "";
  const maps = from.value;
  const inputs: MorphInputs = { from: maps, to: now.to.maps, options: optionsOf(now, maps.length) };
  return JSON.stringify(inputs);
});
const inputs: ReadonlySignal<MorphInputs | null> = computed(() =>
  asked.value === "" ? null : (JSON.parse(asked.value) as MorphInputs),
);

/** The whole path, and the moment on it. */
export const pathPoints: ReadonlySignal<Uv[]> = computed(() =>
  pointsOf(morph.value?.path ?? { kind: "straight", points: [] }),
);
export const moment: ReadonlySignal<number> = computed(() => spaceFrame.value?.t ?? morph.value?.t ?? 0);
export const uv: ReadonlySignal<Uv> = computed(() => uvAt(pathPoints.value, moment.value));

const auto = computed(() => morph.value?.path.kind === "auto");

/**
 * Where the morph holds together, as far as it is known; that of the morph before stays until there is something of the
 * next.
 */
const field = signal<LocusSoFar | null>(null);
export const locus: ReadonlySignal<LocusSoFar | null> = field;
export const locusProblem = signal<string | null>(null);

/** How far the search for a path is; null while there is none. */
export const search = signal<{ share: number } | null>(null);
export const searchProblem = signal<string | null>(null);
/** What the last search came to, and for what. */
export const found = signal<{ of: string; path: PathFound } | null>(null);
/** Whether the search was called off by hand. */
export const calledOff = signal(false);

const checked = signal<{ of: string; check: PathTold } | null>(null);
const checkKey = computed(() =>
  asked.value === "" ? "" : `${asked.value} ${JSON.stringify(pathPoints.value)}`,
);
/** Whether there is no path yet but one that is looked for: what stands in for it is straight, and nobody's choice. */
export const pathless: ReadonlySignal<boolean> = computed(
  () => search.value !== null && auto.value && morph.value?.path.points.length === 0,
);
/** Where the path breaks; null until that is known of this one. */
export const check: ReadonlySignal<PathTold | null> = computed(() =>
  !pathless.value && checked.value?.of === checkKey.value ? checked.value.check : null,
);

/** What the first object is at this moment, before it is moved: that changes nothing about its pieces. */
const shown: ReadonlySignal<string> = computed(() =>
  JSON.stringify(spaceFrame.value?.objects[0]?.maps ?? from.value),
);
interface Judged {
  of: string;
  answer: Connectedness3;
}
const verdict = signal<Judged | null>(null);
/** Whether it is in one piece; `stale` while the answer is about what was seen before. */
export const judged: ReadonlySignal<(Judged & { stale: boolean }) | null> = computed(() => {
  const last = verdict.value;
  return last && { ...last, stale: last.of !== shown.value };
});

const locusTask = new Latest();
const pathTask = new Latest();

/** Keeps all of it up to date. Returns the end of it. */
export function watchMorph(): () => void {
  const stops = [watchLocus(), watchPath(), watchCheck(), watchVerdict()];
  return () => {
    for (const stop of stops) stop();
    locusTask.stop();
    pathTask.stop();
    search.value = null;
  };
}

function watchLocus(): () => void {
  let done: MorphInputs | null = null;
  return effect(() => {
    const now = inputs.value;
    untracked(() => {
      locusTask.stop();
      locusProblem.value = null;
      if (now && now !== done)
        void fill(now, locusTask.begin()).then((whole) => {
          if (whole) done = now;
        });
      else if (!now) field.value = null;
    });
  });
}

/** Whether it came to its end. */
async function fill(now: MorphInputs, end: AbortSignal): Promise<boolean> {
  const take = (so: LocusSoFar) => {
    if (!end.aborted) field.value = so;
  };
  try {
    take(await spaceTask("morphLocus", now, { signal: end, onProgress: take, lane: 2 }));
    return !end.aborted;
  } catch (problem) {
    if (!end.aborted && !isStopped(problem)) locusProblem.value = wordsOf(problem);
    return false;
  }
}

function watchPath(): () => void {
  const stopSearch = effect(() => {
    const key = asked.value;
    const wanted = auto.value;
    untracked(() => {
      pathTask.stop();
      batch(() => {
        search.value = null;
        searchProblem.value = null;
        calledOff.value = false;
      });
      if (wanted && key !== "" && found.peek()?.of !== key) void look(key);
    });
  });
  // Undo may bring back a document from before it was found.
  const stopLaying = effect(() => {
    const known = found.value;
    const { path } = morph.value ?? {};
    if (path?.kind === "auto" && known?.of === asked.value) untracked(() => lay(known.path));
  });
  return () => {
    stopSearch();
    stopLaying();
  };
}

/** Looks for a path once more. */
export function lookAgain(): void {
  const key = asked.peek();
  if (key === "") return;
  calledOff.value = false;
  void look(key);
}

/** Ends the search; the path stays the best that was found. */
export function callOff(): void {
  pathTask.stop();
  search.value = null;
  calledOff.value = true;
}

async function look(key: string): Promise<void> {
  const now = inputs.peek();
  if (!now) return;
  const end = pathTask.begin();
  search.value = { share: 0 };
  const take = (path: PathFound) => {
    if (end.aborted) return;
    batch(() => {
      search.value = path.share < 1 ? { share: path.share } : null;
      if (path.share === 1) found.value = { of: key, path };
      else lay(path);
    });
  };
  try {
    take(await spaceTask("morphPath", now, { signal: end, onProgress: take, lane: 3 }));
  } catch (problem) {
    if (end.aborted || isStopped(problem)) return;
    search.value = null;
    searchProblem.value = wordsOf(problem);
  }
}

/** Decimals that a waypoint is kept with: finer than anyone sees, and short in a link. */
const DIGITS = 1e4;
const kept = (x: number) => Math.round(x * DIGITS) / DIGITS || 0;

/**
 * Puts a path that was found into the document. It was asked for with the choice, so that it is no undo step of its
 * own.
 */
function lay({ plan }: PathFound): void {
  const now = space.peek();
  const before = now?.morph;
  if (!now || before?.path.kind !== "auto") return;
  const way = thinned(plan.points, MOST_POINTS + 2).slice(1, -1);
  const points = way.map(([u, v]): PathPoint => [kept(u), kept(v)]);
  if (JSON.stringify(points) !== JSON.stringify(before.path.points)) {
    const packed = solid.packSpace(withPath(now, { kind: "auto", points }));
    replace({ ...scene.peek(), space: { ...spacePart.peek(), packed } });
  }
}

function watchCheck(): () => void {
  const turn = new InTurn();
  const stop = effect(() => {
    const key = checkKey.value;
    if (key === "" || checked.peek()?.of === key) return;
    turn.ask(async () => {
      const now = inputs.peek();
      // Only the path that is there when its turn comes.
      const of = checkKey.peek();
      if (!now || checked.peek()?.of === of) return;
      try {
        const points = pathPoints.peek();
        const result = await spaceTask("morphCheck", { ...now, points });
        checked.value = { of, check: result };
      } catch {
        // The map beside it says so, too.
      }
    });
  });
  return () => {
    stop();
    turn.clear();
  };
}

function watchVerdict(): () => void {
  const turn = new InTurn();
  const stop = effect(() => {
    if (shown.value === "[]" || verdict.peek()?.of === shown.value) return;
    turn.ask(async () => {
      const of = shown.peek();
      if (verdict.peek()?.of === of) return;
      try {
        const maps = JSON.parse(of) as MapRow3[];
        verdict.value = { of, answer: await spaceTask("holds", { maps }) };
      } catch {
        verdict.value = null;
      }
    });
  });
  return () => {
    stop();
    turn.clear();
  };
}
