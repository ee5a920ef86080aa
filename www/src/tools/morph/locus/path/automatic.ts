/** The automatic path: takes what was planned into the document. */
import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { inputs as morph } from "#compute/inputs";
import type { LocusInputs } from "#compute/locus/job";
import {
  isBetter,
  leavesPlane,
  plan3,
  planned,
  samePoints,
  searchThird,
  stopSearch,
  wayOf,
} from "#compute/plan";
import { plan as flatPlan, publish } from "#compute/results";
import { announce, notify, wordsOf } from "#document/notice";
import { edit, replace, scene } from "#document/scene";
import type { PathPlan } from "#wasm/api";
import * as messages from "../messages";

/** The pair that the waypoints of an automatic path belong to. A link's own points are left as they were sent. */
const settledFor = signal<LocusInputs | null>(null);

const wished = signal(false);
/** Whether automatic paths may use the third parameter. */
export const third: ReadonlySignal<boolean> = wished;

/** The document was opened with these waypoints: they stand until the pair changes. */
export function adoptPath(): void {
  const { path } = scene.peek();
  const whole = path.kind === "auto" && path.points.length > 0;
  settledFor.value = whole ? morph.peek() : null;
  wished.value = whole && leavesPlane(path.points);
}

/** Changes from which end the pair is looked at: a path that has settled is the same path from there. */
export function keepingPath(change: () => void): void {
  const settled = settledFor.peek() === morph.peek();
  change();
  if (settled) settledFor.value = morph.peek();
}

function apply(plan: PathPlan, inputs: LocusInputs): void {
  const now = scene.peek();
  if (now.path.kind !== "auto" || settledFor.peek() === inputs) return;
  const points = wayOf(plan);
  if (!samePoints(points, now.path.points)) replace({ ...now, path: { kind: "auto", points } });
}

/** Looks for a path through three parameters. `asked`: by hand, so that taking it is a step that can be undone. */
function lookFurther(inputs: LocusInputs, asked: boolean): void {
  searchThird(inputs, {
    found(plan) {
      const flat = flatPlan.peek();
      const points = wayOf(plan);
      if (!leavesPlane(points) || (flat && !isBetter(plan, flat))) {
        if (asked) announce(messages.thirdParameterDoesNot);
        wished.value = false;
        if (flat) {
          settledFor.value = null;
          apply(flat, inputs);
          settledFor.value = inputs;
        }
        return;
      }
      const change = { ...scene.peek(), path: { kind: "auto" as const, points } };
      settledFor.value = inputs;
      if (asked) edit(() => change);
      else if (scene.peek().path.kind === "auto") replace(change);
    },
    failed(problem) {
      wished.value = false;
      notify({
        kind: "error",
        text: messages.thirdFailed(wordsOf(problem)),
      });
    },
  });
}

/** Lets the automatic path use the third parameter, or keeps it in the plane. */
export function setThird(on: boolean): void {
  wished.value = on;
  const inputs = morph.peek();
  if (on) {
    lookFurther(inputs, true);
    return;
  }
  stopSearch();
  const flat = flatPlan.peek();
  const { path } = scene.peek();
  if (path.kind !== "auto" || !leavesPlane(path.points)) return;
  settledFor.value = flat ? inputs : null;
  edit((before) => ({ ...before, path: { kind: "auto", points: flat ? wayOf(flat) : [] } }));
}

/** Choosing the automatic path takes the plan that is already there; what undo brings back is left as it was. */
export function watchAutomaticPath(): void {
  let before = scene.peek().path.kind;
  effect(() => {
    const { kind, points } = scene.value.path;
    const plan = flatPlan.value;
    untracked(() => {
      if (kind === "auto" && before !== "auto") {
        settledFor.value = null;
        if (plan && !wished.peek()) {
          apply(plan, morph.peek());
          // Through all samples already: nothing is looked for any more.
          const known = planned.peek();
          if (known?.whole && known.inputs === morph.peek()) settledFor.value = known.inputs;
        }
      }
      before = kind;
      const looking = plan3.peek()?.plan === null;
      if (kind === "auto" && !looking) wished.value = leavesPlane(points);
    });
  });
  effect(() => {
    // What breaks on a way that is only stood for is no fault of the one that is looked for.
    publish.sought.value = scene.value.path.kind === "auto" && settledFor.value !== morph.value;
  });
  effect(() => {
    const now = planned.value;
    if (now) untracked(() => take(now.plan, now.inputs, now.whole));
  });
}

function take(plan: PathPlan, inputs: LocusInputs, whole: boolean): void {
  const auto = scene.peek().path.kind === "auto";
  if (whole && auto && wished.peek() && settledFor.peek() !== inputs) lookFurther(inputs, false);
  // A path through three parameters stands until another one is found.
  if (!wished.peek()) apply(plan, inputs);
  if (whole && auto) settledFor.value = inputs;
}
