/** When the locus of the whole plane is computed, by workers or by the graphics card. */
import { effect, untracked } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { cancel, epoch, sliceMilliseconds, submit, workers } from "#workers/pool/engine";
import { inputs as morph } from "../inputs";
import * as messages from "../messages";
import { planFrom } from "../plan";
import { publish } from "../results";
import { locusCard } from "./card/card";
import type { CardChoice } from "./card/trial";
import { BOUNDS, COARSE_SIZE, type LocusInputs, LocusWork, STRIDES } from "./job";
import { homeIsSeen, scheduleWindow } from "./schedule-window";
import { Soon } from "./soon";

/** While something is dragged, a coarse locus that is nearly done is let finish, so that there is one to see. */
const GRACE_MS = 150;
const COARSEST = STRIDES[0];
/** What comes sooner after another change is part of one movement of the hand. */
const DRAG_MS = 400;
/** While something is dragged, the finer of two coarse pictures is taken where it takes no longer than this. */
const FINER_MS = 90;
/** Later than this an unfinished coarse locus is shown all the same. */
const PATIENCE_MS = 250;

/** After so long at rest what only seems to hold is proved, and that is painted once in so long. */
const REST_MS = 400;
const PROOFS_MS = 250;
/** The first proofs wait for the comparison of the card with the workers, but no longer than this. */
const TRIAL_MS = 4000;

let work: LocusWork | null = null;
/** The workers have not begun, as the card is at it. */
let asking = false;
let resting: ReturnType<typeof setTimeout> | undefined;
let choice: CardChoice = "none";
let waiting: ReturnType<typeof setTimeout> | null = null;
const soon = new Soon(paint);

/** The paths are planned from the whole plane, but while another part or plane is looked at, that comes first. */
const priorities = (): [number, number] => (homeIsSeen.peek() ? [50, 15] : [38, 8]);

export function scheduleLocus(card: CardChoice): void {
  choice = card;
  effect(() => {
    const inputs = morph.value;
    epoch.value;
    untracked(() => request(inputs));
  });
  scheduleWindow();
}

function request(inputs: LocusInputs): void {
  if (waiting) clearTimeout(waiting);
  waiting = null;
  clearTimeout(resting);
  cancel("proofs");
  publish.plan.value = null;
  const shown = publish.locus.peek();
  if (shown) publish.locus.value = { ...shown, progress: 0 };
  const age = work ? performance.now() - work.started : GRACE_MS;
  if (work && !work.coarse && (asking || work.progress > 0) && age < GRACE_MS) {
    waiting = setTimeout(() => start(inputs), GRACE_MS - age);
  } else start(inputs);
}

/**
 * What moves with the hand is never seen whole: its coarse picture has twice as many samples a side, if they can be had
 * in time. At rest the coarse picture is only for the moment until the whole one is there.
 */
function firstStride(): 2 | typeof COARSEST {
  if (!work || performance.now() - work.started > DRAG_MS) return COARSEST;
  const milliseconds = (work.pace.patched * COARSE_SIZE ** 2) / Math.max(1, workers.peek().count);
  return milliseconds <= FINER_MS ? 2 : COARSEST;
}

function start(inputs: LocusInputs): void {
  waiting = null;
  const first = firstStride();
  work = new LocusWork(
    inputs,
    {
      painted: (w) => {
        if (w === work && (w.coarse || performance.now() - w.started > PATIENCE_MS))
          soon.ask(w.progress === 1);
      },
      stage: (w, stride) => {
        if (w !== work) return;
        if (stride === first) paint();
        if (stride === 1) {
          considerCard();
          rest(w);
        }
        // A plan through the coarsest samples is as good for a moment, and there in a quarter of the time.
        if (inputs === morph.peek()) planFrom(w, stride === 1 ? 1 : COARSEST);
        else if (waiting) {
          // The grace was for this much; now for what has been asked since.
          clearTimeout(waiting);
          paint();
          start(morph.peek());
        }
      },
      failed: (error) => {
        cancel("locus");
        publish.locus.value = null;
        notify({ kind: "error", text: messages.locusFailed(wordsOf(error)) });
      },
    },
    sliceMilliseconds,
    { patches: true, priorities, first, ...(work && { pace: work.pace }) },
  );
  const mine = work;
  asking = true;
  const begin = () => {
    if (mine !== work || !asking) return;
    asking = false;
    submit(mine.job());
  };
  if (locusCard.found) {
    cancel("locus");
    locusCard.found.whole(mine, () => mine === work, begin);
  } else begin();
}

/** Proves what only seems to hold, when the hand has been at rest for a while. */
function rest(whole: LocusWork): void {
  clearTimeout(resting);
  resting = setTimeout(async () => {
    const { LocusProofs } = await import("./proofs");
    await trial;
    // Without workers the page would have to do it, while it is used.
    if (whole !== work || whole.inputs !== morph.peek() || workers.peek().count === 0) return;
    let painted = performance.now();
    const proofs = new LocusProofs(whole, () => {
      if (whole !== work || (!proofs.done && performance.now() - painted < PROOFS_MS)) return;
      painted = performance.now();
      paint();
    });
    submit(proofs.job());
  }, REST_MS);
}

let trial: Promise<unknown> | null = null;

function considerCard(): void {
  // Fetched when nothing waits for it. Where it cannot be had, all goes on without a card.
  trial ??= Promise.race([
    import("./card/trial").then(({ lookForCard }) => lookForCard(choice)).catch(() => undefined),
    new Promise((resolve) => setTimeout(resolve, TRIAL_MS)),
  ]);
}

function paint(): void {
  soon.cancel();
  if (!work) return;
  const current = work.inputs === morph.peek();
  publish.locus.value = { ...work.filled, bounds: BOUNDS, progress: current ? work.progress : 0 };
}
