/** Keeps the samples of the window coming that the locus view looks at. */
import { computed, effect, type ReadonlySignal, untracked } from "@preact/signals";
import { locusView } from "#document/morph";
import { wordsOf } from "#document/notice";
import type { FrondError, LocusView } from "#wasm/api";
import { cancel, epoch, submit, workers } from "#workers/pool/engine";
import { inputs as morph } from "../inputs";
import * as messages from "../messages";
import { publish } from "../results";
import { locusCard } from "./card/card";
import { detail } from "./detail";
import type { LocusInputs } from "./job";
import { type LocusSource, Pyramid } from "./pyramid";
import { Soon } from "./soon";
import { clampedView, levelOf, viewProblem } from "./window";
import { WindowWork } from "./window-job";

/**
 * While something is dragged, a coarse picture is let finish, so that there is one to see: until then the last one is.
 * Where it takes longer than this, what there is of it is shown, and the next one begun.
 */
const GRACE_MS = 3000;
/** After so long at rest what only seems to hold is proved, and that is painted once in so long. */
const REST_MS = 400;
const PROOFS_MS = 250;

const family = computed(() => locusView.value.family);
const sides = computed(() => locusView.value.sides);
const slice = computed(() => locusView.value.w);
/** The morph besides its path; of no account for the families. */
const inputs = computed<LocusInputs | null>(() => (family.value === "morph" ? morph.value : null));

const source: ReadonlySignal<LocusSource> = computed(() =>
  inputs.value
    ? { family: "morph", inputs: inputs.value, w: Number.isFinite(slice.value) ? slice.value : 0 }
    : { family: "polygon", sides: sides.value },
);

/** Whether the whole plane of the morph, which the paths need, is also what is seen. */
export const homeIsSeen: ReadonlySignal<boolean> = computed(
  () => family.value === "morph" && slice.value === 0 && levelOf(locusView.value.zoom * detail.value) === 0,
);

let pyramid: Pyramid | null = null;
let work: WindowWork | null = null;
let live = false;
/** What the workers are at. */
let begun: WindowWork | null = null;
let failed = false;
let waiting: ReturnType<typeof setTimeout> | null = null;
let resting: ReturnType<typeof setTimeout> | undefined;
const soon = new Soon(paint);

export function scheduleWindow(): void {
  effect(() => {
    const next = source.value;
    epoch.value;
    untracked(() => change(next));
  });
  effect(() => {
    const view = locusView.value;
    detail.value;
    untracked(() => look(view));
  });
  // The whole plane is under the window: what comes in there is seen here.
  effect(() => {
    publish.locus.value;
    untracked(() => {
      if (pyramid?.based && pyramid.shown === pyramid) paint();
    });
  });
}

function change(next: LocusSource): void {
  if (waiting) clearTimeout(waiting);
  waiting = null;
  const age = work ? performance.now() - work.started : GRACE_MS;
  const same = pyramid?.family === next.family;
  if (same && work && live && !work.seen && age < GRACE_MS) {
    waiting = setTimeout(() => start(source.peek()), GRACE_MS - age);
  } else start(next);
}

function start(next: LocusSource): void {
  if (waiting) clearTimeout(waiting);
  waiting = null;
  const based = next.family === "morph" && next.w === 0;
  const before = pyramid?.family === next.family ? pyramid.shown : null;
  pyramid = new Pyramid(next, based ? () => publish.locus.peek() : null, before);
  cancel("window");
  cancel("window-proofs");
  live = false;
  failed = false;
  const mine = pyramid;
  work = new WindowWork(
    mine,
    {
      painted: () => {
        if (mine !== pyramid || !work) return;
        if (performance.now() - work.started > GRACE_MS) mine.forget();
        // As long as it is the last plane that is shown, nothing of this one is seen.
        if (mine.shown === mine) soon.ask(work.progress === 1);
      },
      coarse: () => {
        if (mine !== pyramid) return;
        mine.forget();
        paint();
        // The grace was for this much; now for what has been asked since.
        if (waiting) start(source.peek());
      },
      failed: (error) => {
        if (mine === pyramid) fail(error);
      },
    },
    true,
  );
  look(locusView.peek());
}

function look(view: LocusView): void {
  clearTimeout(resting);
  if (!work || failed || viewProblem(view)) return;
  cancel("window-proofs");
  if (work.want(clampedView(view), detail.peek()) && !live) {
    live = true;
    const mine = work;
    const done = () => {
      begun = null;
      if (mine !== work) return;
      live = false;
      paint();
      look(locusView.peek());
    };
    const begin = () => {
      if (mine !== work || mine === begun) return;
      begun = mine;
      submit({ ...mine.job(), done });
    };
    if (locusCard.found) locusCard.found.tiles(mine, () => mine === work, begin);
    else begin();
  }
  if (work.seen) pyramid?.forget();
  if (!live && !homeIsSeen.peek()) resting = setTimeout(() => prove(view), REST_MS);
  paint();
}

/** Proves what only seems to hold in a window that is known, when it has been looked at for a while. */
async function prove(view: LocusView): Promise<void> {
  const mine = work;
  const { WindowProofs } = await import("./window-proofs");
  // Without workers the page would have to do it, while it is used.
  if (!mine || mine !== work || view !== locusView.peek() || live || workers.peek().count === 0) return;
  let painted = performance.now();
  const proofs = new WindowProofs(mine, clampedView(view), detail.peek(), () => {
    if (mine !== work || (!proofs.done && performance.now() - painted < PROOFS_MS)) return;
    painted = performance.now();
    paint();
  });
  submit(proofs.job());
}

function fail(error: FrondError): void {
  cancel("window");
  live = false;
  failed = true;
  if (!pyramid) return;
  publish.window.value = { pyramid, progress: 1, problem: messages.windowFailed(wordsOf(error)) };
}

function paint(): void {
  soon.cancel();
  if (!pyramid || failed) return;
  const whole = homeIsSeen.peek() ? (publish.locus.peek()?.progress ?? 0) : (work?.progress ?? 0);
  publish.window.value = { pyramid, progress: waiting ? 0 : whole, problem: null };
}
