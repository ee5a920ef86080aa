/** Which map becomes which: ways to match, rated by the paths that they leave open. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { pairing } from "#document/morph";
import { wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import type { Candidate, MapRow, Mode, RatedCandidate } from "#wasm/api";
import { cancel, epoch, submit } from "#workers/pool/engine";
import type { Job, Kind, Task } from "#workers/pool/protocol";
import { EPSILON } from "./locus/job";
import * as messages from "./messages";

/** How many ways to match are offered. */
const MOST_MATCHINGS = 12;
/** Samples a side of their loci: 3 k + 1, so that both ends are samples. */
const RATE_SIZE = 64;

/** Ways to match the maps of a pair: what is rated so far, the best first. */
interface Matchings {
  from: MapRow[];
  to: MapRow[];
  mode: Mode;
  rated: RatedCandidate[];
  /** How many are to be rated; null until the candidates are there. */
  of: number | null;
  /** How many are done, those that could not be rated among them. */
  done: number;
  problem: string | null;
}

const latest = signal<Matchings | null>(null);
const mode = computed(() => scene.value.mode);

/** About the present pair; null where it was not asked for. */
export const matchings: ReadonlySignal<Matchings | null> = computed(() => {
  const now = latest.value;
  const { from, to } = pairing.value;
  return now && now.from === from && now.to === to && now.mode === mode.value ? now : null;
});

/** Those that hold first, then the narrowest gap, the most room, the plainest. */
export function byMerit(p: RatedCandidate, q: RatedCandidate): number {
  if (p.plan.holds !== q.plan.holds) return p.plan.holds ? -1 : 1;
  const gaps = p.plan.holds ? 0 : finite(p.plan.gap, 1e9) - finite(q.plan.gap, 1e9);
  if (Math.abs(gaps) > 1e-9) return gaps;
  const room = finite(q.plan.clearance, 0) - finite(p.plan.clearance, 0);
  if (Math.abs(room) > 1e-3) return room;
  return finite(p.cost, 1e9) - finite(q.cost, 1e9);
}

const finite = (x: number | undefined, otherwise: number): number =>
  x !== undefined && Number.isFinite(x) ? x : otherwise;

/** Looks for other ways to match, and rates each by the path that it allows. */
export function lookForMatchings(): void {
  const { from, to } = pairing.peek();
  latest.value = { from, to, mode: mode.peek(), rated: [], of: null, done: 0, problem: null };
  submit(matchJob(latest.value));
}

export function stopMatching(): void {
  cancel("candidates");
  const now = latest.peek();
  if (now) latest.value = now.rated.length > 0 ? { ...now, of: now.done } : null;
}

function matchJob({ from, to, mode }: Matchings): Job<"candidates" | "rate"> {
  let first = true;
  const todo: Candidate[] = [];
  const update = (change: (now: Matchings) => Matchings) => {
    const now = latest.peek();
    if (now && now.from === from && now.to === to && now.mode === mode) latest.value = change(now);
  };
  return {
    channel: "candidates",
    priority: () => 11,
    next() {
      if (first) {
        first = false;
        return { kind: "candidates", from, to, limit: MOST_MATCHINGS };
      }
      const candidate = todo.shift();
      if (!candidate) return null;
      const { correspondence, turns } = candidate;
      const options = { mode, correspondence, turns, size: RATE_SIZE, epsilon: EPSILON };
      return { kind: "rate", from, to, options };
    },
    accept(task, result) {
      if (isOf("candidates", task)) {
        const found = (result as Candidate[]).slice(0, MOST_MATCHINGS);
        todo.push(...found);
        update((now) => ({ ...now, of: found.length }));
        return;
      }
      const rated = result as RatedCandidate;
      update((now) => ({ ...now, done: now.done + 1, rated: [...now.rated, rated].sort(byMerit) }));
    },
    fail(task, error) {
      const all = isOf("candidates", task);
      update((now) => ({
        ...now,
        done: all ? now.done : now.done + 1,
        of: all ? 0 : now.of,
        problem: all ? messages.pairingsFailed(wordsOf(error)) : now.problem,
      }));
    },
  };
}

function isOf<K extends Kind>(kind: K, task: Task): task is Task<K> {
  return task.kind === kind;
}

export function scheduleMatching(): void {
  effect(() => {
    matchings.value;
    untracked(() => {
      if (latest.peek() && !matchings.peek()) {
        cancel("candidates");
        latest.value = null;
      }
    });
  });
  effect(() => {
    epoch.value;
    untracked(stopMatching);
  });
}
