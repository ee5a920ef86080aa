import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { announce, notify, wordsOf } from "#document/notice";
import { edit, replace, scene } from "#document/scene";
import { thinned } from "#geometry/path";
import type { PathPlan, PathPoint } from "#wasm/api";
import { cancel, submit, workers } from "#workers/pool/engine";
import { single, type Task } from "#workers/pool/protocol";
import { inputs as morph } from "./inputs";
import { BOUNDS, EPSILON, type LocusInputs, type LocusWork } from "./locus/job";
import { publish } from "./results";

const MOST_POINTS = 64;

/** The pair that the way points of an automatic path belong to. A link's own points are left as they were sent. */
let settled: LocusInputs | null = null;

/** What is known of a path through three parameters. */
export interface Plan3 {
  /** Where it is known of which pair; elsewhere it is out of date. */
  inputs: LocusInputs;
  /** Null while it is being looked for. */
  plan: PathPlan | null;
}

const wished = signal(false);
const found3 = signal<Plan3 | null>(null);
/** Whether automatic paths may use the third parameter. */
export const third: ReadonlySignal<boolean> = wished;
export const plan3: ReadonlySignal<Plan3 | null> = found3;

/** Whether a path leaves the plane w = 0. */
export const leavesPlane = (points: readonly PathPoint[]): boolean =>
  points.some(([, , w]) => (w ?? 0) !== 0);

/** The document was opened with these way points: they stand until the pair changes. */
export function adoptPath(): void {
  const { path } = scene.peek();
  const whole = path.kind === "auto" && path.points.length > 0;
  settled = whole ? morph.peek() : null;
  wished.value = whole && leavesPlane(path.points);
}

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
        const auto = scene.peek().path.kind === "auto";
        if (stride === 1 && auto && wished.peek() && settled !== inputs) lookFurther(inputs, false);
        // A path through three parameters stands until another one is found.
        if (!wished.peek()) apply(plan, inputs);
        if (stride === 1 && auto) settled = inputs;
      },
      fail: (error) => notify({ kind: "error", text: `No path could be planned: ${wordsOf(error)}` }),
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

function apply(plan: PathPlan, inputs: LocusInputs): void {
  const now = scene.peek();
  if (now.path.kind !== "auto" || settled === inputs) return;
  const points = wayOf(plan);
  if (!samePoints(points, now.path.points)) replace({ ...now, path: { kind: "auto", points } });
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

/** Looks for a path through three parameters. `asked`: by hand, so that taking it is a step that can be undone. */
function lookFurther(inputs: LocusInputs, asked: boolean): void {
  const { from, to, options } = inputs;
  found3.value = { inputs, plan: null };
  const giveUp = (text: string) => {
    found3.value = null;
    wished.value = false;
    notify({ kind: "error", text });
  };
  submit(
    single<"plan3">(
      "plan3",
      22,
      { kind: "plan3", from, to, options: { ...options, epsilon: EPSILON, axes: 3 } },
      {
        accept: (plan) => {
          if (inputs !== morph.peek()) return;
          found3.value = { inputs, plan };
          const flat = publish.plan.peek();
          const points = wayOf(plan);
          if (!leavesPlane(points) || (flat && !isBetter(plan, flat))) {
            if (asked) announce("The third parameter does not help here.");
            wished.value = false;
            if (flat) {
              settled = null;
              apply(flat, inputs);
              settled = inputs;
            }
            return;
          }
          const change = { ...scene.peek(), path: { kind: "auto" as const, points } };
          settled = inputs;
          if (asked) edit(() => change);
          else if (scene.peek().path.kind === "auto") replace(change);
        },
        fail: (error) => giveUp(`No path through three parameters could be found: ${wordsOf(error)}`),
      },
    ),
  );
}

/** Lets the automatic path use the third parameter, or keeps it in the plane. */
export function setThird(on: boolean): void {
  wished.value = on;
  const inputs = morph.peek();
  if (on) {
    lookFurther(inputs, true);
    return;
  }
  cancel("plan3");
  if (found3.peek()?.plan === null) found3.value = null;
  const flat = publish.plan.peek();
  const { path } = scene.peek();
  if (path.kind !== "auto" || !leavesPlane(path.points)) return;
  settled = flat ? inputs : null;
  edit((before) => ({ ...before, path: { kind: "auto", points: flat ? wayOf(flat) : [] } }));
}

/** Choosing the automatic path takes the plan that is already there; what undo brings back is left as it was. */
export function schedulePlan(): void {
  let before = scene.peek().path.kind;
  effect(() => {
    const { kind, points } = scene.value.path;
    const plan = publish.plan.value;
    untracked(() => {
      if (kind === "auto" && before !== "auto") {
        settled = null;
        if (plan && !wished.peek()) apply(plan, morph.peek());
      }
      before = kind;
      const looking = found3.peek()?.plan === null;
      if (kind === "auto" && !looking) wished.value = leavesPlane(points);
    });
  });
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
