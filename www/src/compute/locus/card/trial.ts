/** Looks for a graphics card for the locus when the page has come to rest, and times it against the workers. */
import { effect } from "@preact/signals";
import { playing } from "#document/playback";
import { inGesture } from "#document/scene";
import { CardQueue, type Ends, isFaster, type LocusCompute, mayHaveCard, openCard } from "#wasm/locus-card";
import { submit, workers } from "#workers/pool/engine";
import type { Task } from "#workers/pool/protocol";
import { type LocusWork, nextKey } from "../job";
import { locusCard } from "./card";
import { PATIENCE_MS, tilesByCard } from "./tiles";

/** Which card decides loci: one that is faster, one on the processor too and untimed, or none. For trying the page. */
export type CardChoice = "auto" | "software" | "none";

/** The page has nothing to do for so long before it looks, and it looks between two frames. */
const REST_MS = 600;
/** A comparison that something else came into says nothing; one that always does is given up. */
const TRIES = 3;

const atRest = () => !playing.value && !inGesture.value && !workers.value.busy && workers.value.available;

/** Once; called when the first locus is whole, which does not wait for a card. */
export async function lookForCard(choice: CardChoice): Promise<void> {
  if (choice === "none" || !(await mayHaveCard(choice === "software"))) return;
  await rest();
  const found = await openCard(choice === "software");
  if (!found) return;
  if (choice === "software" || (await proves(found))) adopt(found);
  else found.free();
}

/** From here on loci are decided by this card, until it fails. */
function adopt(found: LocusCompute): void {
  const queue = new CardQueue(found, () => {
    locusCard.found = null;
  });
  locusCard.found = {
    whole: (work, wanted, begin) => beforeWorkers(wholeByCard(queue, work, wanted), begin),
    tiles: (work, wanted, begin) => beforeWorkers(tilesByCard(queue, work, wanted), begin),
  };
}

/** The workers begin when the card is done, or is late. */
async function beforeWorkers(byCard: Promise<void>, begin: () => void): Promise<void> {
  const late = setTimeout(begin, PATIENCE_MS);
  await byCard;
  clearTimeout(late);
  begin();
}

/** All samples at once. */
async function wholeByCard(queue: CardQueue, work: LocusWork, wanted: () => boolean): Promise<void> {
  const found = await queue.ask(work.whole(), wanted);
  if (found && wanted()) work.acceptWhole(found);
}

async function proves(found: LocusCompute): Promise<boolean> {
  for (let tries = 0; tries < TRIES; tries++) {
    await rest();
    const disturbed = watch(() => playing.value || inGesture.value);
    const faster = await isFaster(found, onProcessor);
    if (!disturbed.end()) return faster;
  }
  return false;
}

function rest(): Promise<void> {
  return new Promise((resolve) => {
    let timer: ReturnType<typeof setTimeout> | null = null;
    const stop = effect(() => {
      const now = atRest();
      if (timer) clearTimeout(timer);
      timer = now ? setTimeout(end, REST_MS) : null;
    });
    function end() {
      stop();
      // Safari has none.
      if (typeof requestIdleCallback === "function") requestIdleCallback(() => resolve());
      else resolve();
    }
  });
}

/** Whether something came to pass between now and the end. */
function watch(happens: () => boolean): { end(): boolean } {
  let seen = false;
  const stop = effect(() => {
    seen ||= happens();
  });
  return {
    end() {
      stop();
      return seen;
    },
  };
}

/** All rows by all workers. */
function onProcessor({ from, to, options }: Ends): Promise<void> {
  const key = nextKey();
  const part = Math.ceil(options.height / 8);
  let r0 = 0;
  return new Promise((resolve, reject) => {
    submit({
      channel: "card",
      priority: () => 5,
      next() {
        if (r0 >= options.height) return null;
        const r1 = Math.min(options.height, r0 + part);
        const task: Task<"locus"> = { kind: "locus", key, from, to, options, r0, r1, stride: 1, first: true };
        r0 = r1;
        return task;
      },
      accept() {},
      fail: (_, error) => reject(error),
      done: resolve,
    });
  });
}
