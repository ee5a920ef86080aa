import { effect, untracked } from "@preact/signals";
import { notify, wordsOf } from "../../state/notice";
import { thinned } from "../../state/path";
import { replace, scene } from "../../state/scene";
import type { PathPlan } from "../api";
import { submit } from "../engine";
import { BOUNDS, EPSILON, type LocusInputs, type LocusWork } from "../locus-job";
import { single, type Task } from "../protocol";
import { publish } from "../results";
import { inputs as morph } from "./inputs";

const MOST_POINTS = 64;

/** The pair that the way points of an automatic path belong to. A link's own points are left as they were sent. */
let settled: LocusInputs | null = null;

/** The document was opened with these way points: they stand until the pair changes. */
export function adoptPath(): void {
  const { path } = scene.peek();
  settled = path.kind === "auto" && path.points.length > 0 ? morph.peek() : null;
}

/** Plans through the samples that are in; each stage knows the field better than the one before. */
export function planFrom(work: LocusWork, stride: number): void {
  const inputs = work.inputs;
  const task: Task<"plan"> = { kind: "plan", locus: work.nested(stride), bounds: BOUNDS };
  // Only once all is known and at rest, and only off the page's own thread: this may take a second.
  if (stride === 1 && publish.workers.peek().available) {
    const { from, to, options } = inputs;
    task.refine = { from, to, options: { ...options, epsilon: EPSILON } };
  }
  submit(
    single<"plan">("plan", 48, task, {
      accept: (plan) => {
        if (inputs !== morph.peek()) return;
        publish.plan.value = plan;
        apply(plan, inputs);
        if (stride === 1 && scene.peek().path.kind === "auto") settled = inputs;
      },
      fail: (error) => notify({ kind: "error", text: `No path could be planned: ${wordsOf(error)}` }),
    }),
  );
}

function apply(plan: PathPlan, inputs: LocusInputs): void {
  const now = scene.peek();
  if (now.path.kind !== "auto" || settled === inputs) return;
  const points = thinned(plan.points, MOST_POINTS + 2)
    .slice(1, -1)
    .map(([u, v]): [number, number] => [short(u), short(v)]);
  const same =
    points.length === now.path.points.length &&
    points.every(([u, v], i) => u === now.path.points[i]?.[0] && v === now.path.points[i]?.[1]);
  if (!same) replace({ ...now, path: { kind: "auto", points } });
}

/** Short in a link, and still far nearer to its sample than the resolution can tell. */
function short(x: number): number {
  return Math.round(x * 1e6) / 1e6;
}

/** Choosing the automatic path takes the plan that is already there. */
export function schedulePlan(): void {
  let before = scene.peek().path.kind;
  effect(() => {
    const { kind } = scene.value.path;
    const plan = publish.plan.value;
    untracked(() => {
      if (kind === "auto" && before !== "auto") {
        settled = null;
        if (plan) apply(plan, morph.peek());
      }
      before = kind;
    });
  });
}
