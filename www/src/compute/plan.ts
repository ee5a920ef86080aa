/** The path that is planned for the present pair, in the plane or through three parameters. */
import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { thinned } from "#geometry/path";
import type { PathPlan, PathPoint } from "#wasm/api";
import { cancel, submit, workers } from "#workers/pool/engine";
import { single, type Task } from "#workers/pool/protocol";
import { inputs as morph } from "./inputs";
import { BOUNDS, EPSILON, type LocusInputs, type LocusWork } from "./locus/job";
import * as messages from "./messages";
import { publish } from "./results";

const MOST_POINTS = 64;

/** A path through the plane w = 0. */
interface Planned {
  inputs: LocusInputs;
  plan: PathPlan;
  /** Through all samples, not through the coarse ones that come first. */
  whole: boolean;
}

/** What is known of a path through three parameters. */
interface Plan3 {
  /** Where it is known of which pair; elsewhere it is out of date. */
  inputs: LocusInputs;
  /** Null while it is being looked for. */
  plan: PathPlan | null;
}

const found = signal<Planned | null>(null);
const found3 = signal<Plan3 | null>(null);
/** The last one that was found for the pair of its time. */
export const planned: ReadonlySignal<Planned | null> = found;
export const plan3: ReadonlySignal<Plan3 | null> = found3;

/** Whether a path leaves the plane w = 0. */
export const leavesPlane = (points: readonly PathPoint[]): boolean =>
  points.some(([, , w]) => (w ?? 0) !== 0);

/** Plans through the samples that are in; each stage knows the field better than the one before. */
export function planFrom(work: LocusWork, stride: number): void {
  const inputs = work.inputs;
  const task: Task<"plan"> = { kind: "plan", locus: work.nested(stride), bounds: BOUNDS };
  // Only once all is known and at rest, and only off the page's own thread: this may take a second.
  if (stride === 1 && workers.peek().available) {
    const { from, to, options } = inputs;
    task.refine = { from, to, options: { ...options, epsilon: EPSILON } };
  }
  submit(
    single<"plan">("plan", 48, task, {
      accept: (plan) => {
        if (inputs !== morph.peek()) return;
        publish.plan.value = plan;
        found.value = { inputs, plan, whole: stride === 1 };
      },
      fail: (error) => notify({ kind: "error", text: messages.planFailed(wordsOf(error)) }),
    }),
  );
}

/** The points between the ends as the document keeps them. */
export function wayOf(plan: PathPlan): PathPoint[] {
  return thinned(plan.points, MOST_POINTS + 2)
    .slice(1, -1)
    .map(
      ([u, v, w = 0]): PathPoint => (short(w) === 0 ? [short(u), short(v)] : [short(u), short(v), short(w)]),
    );
}

export function samePoints(p: readonly PathPoint[], q: readonly PathPoint[]): boolean {
  return (
    p.length === q.length &&
    p.every(([u, v, w = 0], i) => {
      const other = q[i];
      return u === other?.[0] && v === other[1] && w === (other[2] ?? 0);
    })
  );
}

/** Short in a link, and still far nearer to its sample than the resolution can tell. */
function short(x: number): number {
  return Math.round(x * 1e6) / 1e6 || 0;
}

/** A path through three parameters is better if it breaks less, or holds where the other does not. */
export function isBetter(other: PathPlan, plan: PathPlan): boolean {
  if (other.holds !== plan.holds) return other.holds;
  return !other.holds && other.gap < 0.95 * plan.gap;
}

/** Looks for a path through three parameters. */
export function searchThird(
  inputs: LocusInputs,
  then: { found(plan: PathPlan): void; failed(problem: unknown): void },
): void {
  const { from, to, options } = inputs;
  found3.value = { inputs, plan: null };
  submit(
    single<"plan3">(
      "plan3",
      22,
      { kind: "plan3", from, to, options: { ...options, epsilon: EPSILON, axes: 3 } },
      {
        accept: (plan) => {
          if (inputs !== morph.peek()) return;
          found3.value = { inputs, plan };
          then.found(plan);
        },
        fail: (problem) => {
          found3.value = null;
          then.failed(problem);
        },
      },
    ),
  );
}

export function stopSearch(): void {
  cancel("plan3");
  if (found3.peek()?.plan === null) found3.value = null;
}

/** What was found of another pair is let go. */
export function schedulePlan(): void {
  effect(() => {
    const inputs = morph.value;
    untracked(() => {
      if (found3.peek() && found3.peek()?.inputs !== inputs) {
        cancel("plan3");
        found3.value = null;
      }
    });
  });
}
