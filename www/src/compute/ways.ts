/** Other ways to bring the present pair together, looked for by themselves where the automatic path breaks. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { sameMaps } from "#geometry/maps/same-maps";
import { weighted } from "#geometry/maps/weighted";
import { isBroken } from "#geometry/states";
import type { Ifs, Mode, PathPlan, Route } from "#wasm/api";
import { cancel, epoch, submit } from "#workers/pool/engine";
import type { Job, Kind, Task } from "#workers/pool/protocol";
import { inputs as morph } from "./inputs";
import { EPSILON, type LocusInputs } from "./locus/job";
import { leavesPlane } from "./plan";
import { along, plan, stuck } from "./results";

/** A way with the path that it allows. */
export interface Offer {
  /** Null is the way that is taken now, with the third parameter. */
  way: Route | null;
  plan: PathPlan;
}

/** What is known of other ways than the present one, which breaks. */
export interface Search {
  a: Ifs;
  b: Ifs;
  inputs: LocusInputs;
  weights: string;
  /** The widest gap of the path that is there. */
  gap: number;
  /** How many ways there are to try, and how many were; null until they are listed. */
  of: number | null;
  done: number;
  /** The best that was found, if it is better than what is there. */
  best: Offer | null;
  /** Whether nothing is looked for any more. */
  over: boolean;
  problem: string | null;
}

/** As long as nothing else is to be done, and after the map of the locus has been proved. */
const PRIORITY = 3;
/** Ways that are looked at, at most, and how long the workers may take for all of them. */
const MOST_WAYS = 240;
const MOST_MILLISECONDS = 60_000;
/** After so many coarse looks comes a close one. */
const BETWEEN = 12;
/** Ways that are tried before the third parameter is. */
const FIRST = 12;
/** Rest before it begins: whoever drags or tries shapes waits for nothing of it. */
const REST_MS = 500;
/** Ways that are looked at closely where none holds at first sight: finer maps find ways through what is narrow. */
const MOST_CLOSE = 24;
/** A gap that is not narrower than by this is no better. */
const NARROWER = 0.95;

const latest = signal<Search | null>(null);
const firstWeights = computed(() => scene.value.a.weights);
const lastWeights = computed(() => scene.value.b.weights);
/** No way hangs on the weights, but each brings them along. */
const weights = computed(() => JSON.stringify([firstWeights.value, lastWeights.value]));

/** Whether one of the shapes is itself in pieces: then nothing can hold all the way. */
export const endBroken: ReadonlySignal<boolean> = computed(() => {
  const states = along.value?.states;
  return (
    states !== undefined && [states[0], states.at(-1)].some((state) => state !== undefined && isBroken(state))
  );
});

const same = (p: LocusInputs, q: LocusInputs): boolean =>
  p === q ||
  (sameMaps(p.from, q.from) &&
    sameMaps(p.to, q.to) &&
    JSON.stringify(p.options) === JSON.stringify(q.options));

/** About the present pair; null where nothing was looked for. */
export const otherWays: ReadonlySignal<Search | null> = computed(() => {
  const now = latest.value;
  return now !== null && same(now.inputs, morph.value) && now.weights === weights.value ? now : null;
});

/** Whether `plan` is better than a gap, or than another that was found before. */
export function isBetterThan(plan: PathPlan, gap: number, best: Offer | null): boolean {
  if (best?.plan.holds) return false;
  return plan.holds || plan.gap < NARROWER * Math.min(gap, best?.plan.gap ?? Number.POSITIVE_INFINITY);
}

/** Looks for them, unless it was done. */
function look(): void {
  const inputs = morph.peek();
  const before = otherWays.peek();
  if (before?.over) return;
  const { a, b } = scene.peek();
  const gap = along.peek()?.worst?.gap ?? plan.peek()?.gap ?? Number.POSITIVE_INFINITY;
  latest.value = {
    a: weighted(a.maps, a.weights),
    b: weighted(b.maps, b.weights),
    inputs,
    weights: weights.peek(),
    gap,
    of: null,
    done: 0,
    best: null,
    over: false,
    problem: null,
  };
  submit(searchJob(latest.value));
}

export function stopLooking(): void {
  cancel("ways");
  const now = latest.peek();
  if (now && !now.over) latest.value = { ...now, over: true };
}

function searchJob({ a, b, inputs, gap }: Search): Job<"ways" | "way" | "plan3"> {
  let listed = false;
  let todo: (Route | null)[] = [];
  let spent = 0;
  const asked = new Map<object, Route | null>();
  /** What a coarse look has said of ways that break. */
  const rated: { way: Route; gap: number }[] = [];
  let close = 0;
  let handed = 0;
  let over = false;
  const set = (change: (now: Search) => Partial<Search>) => {
    const now = latest.peek();
    if (now?.inputs === inputs) latest.value = { ...now, ...change(now) };
  };
  const mode: Mode = inputs.options.mode ?? "polar";
  const ask = (way: Route | null, task: Task<"way" | "plan3">) => {
    asked.set(task, way);
    return task;
  };
  /** The next of those that break least at first sight. */
  const closer = () => {
    if (close >= MOST_CLOSE) return null;
    const next = rated.sort((p, q) => p.gap - q.gap).shift();
    if (!next) return null;
    close++;
    return ask(next.way, askFor(next.way, mode, true));
  };
  return {
    channel: "ways",
    priority: () => PRIORITY,
    next() {
      if (!listed) {
        listed = true;
        return { kind: "ways", from: a, to: b, limit: MOST_WAYS };
      }
      if (over) return null;
      // What seems near to holding need not wait until all are seen.
      const now = ++handed % BETWEEN === 0 ? closer() : null;
      if (now) return now;
      const way = todo.shift();
      if (way === undefined) return closer();
      return ask(way, way === null ? throughThird(inputs) : askFor(way, mode, false));
    },
    accept(task, result, milliseconds) {
      spent += milliseconds;
      if (isOf("ways", task)) {
        const ways = result as Route[];
        // The way that is there, with a parameter more, is plain, and takes long: after those that are most likely.
        todo = mode === "polar" ? [...ways.slice(0, FIRST), null, ...ways.slice(FIRST)] : ways;
        set(() => ({ of: todo.length }));
        return;
      }
      const found = result as PathPlan;
      const way = asked.get(task) ?? null;
      const first = !(isOf("way", task) && task.closely);
      if (way && first && !found.holds && way.kind !== "joints") rated.push({ way, gap: found.gap });
      set(({ best, done }) => {
        // A path of the search through three parameters that stays in the plane is the one that is there.
        const other = way !== null || leavesPlane(found.points);
        const better = other && isBetterThan(found, gap, best);
        return { done: done + (first ? 1 : 0), best: better ? { way, plan: found } : best };
      });
      if (latest.peek()?.best?.plan.holds || spent > MOST_MILLISECONDS) {
        todo = [];
        over = true;
      }
    },
    fail(task, error) {
      if (isOf("ways", task)) set(() => ({ problem: wordsOf(error) }));
      else set(({ done }) => ({ done: done + 1 }));
    },
    done: () => set(() => ({ over: true })),
  };
}

const throughThird = ({ from, to, options }: LocusInputs): Task<"plan3"> => ({
  kind: "plan3",
  from,
  to,
  options: { ...options, epsilon: EPSILON, axes: 3 },
});

function askFor(way: Route, mode: Mode, closely: boolean): Task<"way"> {
  const { from, to, correspondence, turns, kind } = way;
  const options = { mode: way.mode ?? mode, correspondence, turns, epsilon: EPSILON };
  return { kind: "way", from, to, options, straight: kind === "joints", closely };
}

function isOf<K extends Kind>(kind: K, task: Task): task is Task<K> {
  return task.kind === kind;
}

let begun = false;

/** From the first time on that a path is stuck. */
export function scheduleWays(): void {
  if (begun) return;
  begun = true;
  let timer: ReturnType<typeof setTimeout> | null = null;
  effect(() => {
    const now = stuck.value;
    morph.value;
    weights.value;
    epoch.value;
    untracked(() => {
      if (timer) clearTimeout(timer);
      timer = null;
      // What was being looked for is of another pair, or not needed any more.
      const open = latest.peek();
      if (open !== null && !open.over) {
        cancel("ways");
        latest.value = null;
      }
      if (now && !endBroken.peek()) timer = setTimeout(look, REST_MS);
    });
  });
}
