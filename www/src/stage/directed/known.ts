/** What is known of the graph-directed shape at the present moment, a little behind it, and of the way. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { standInFilm } from "#compute/results";
import { directedMoment, directedWay } from "#document/directed/directed";
import { wordsOf } from "#document/notice";
import { CURVES, standInWords } from "#document/stand-in";
import {
  OWN_BOUNDS,
  phraseOf,
  RESOLUTION,
  type Told,
  type VerdictWords,
  verdictWords,
} from "#format/verdict";
import type { DirectedCertificate, DirectedMatch } from "#wasm/api";
import { toError } from "#wasm/error";
import { directedTask } from "#workers/directed/client";
import type { Moment, Way } from "#workers/directed/moment";
import type { Tasks } from "#workers/directed/tasks";
import { InTurn, isStopped } from "#workers/lanes/latest";
import type { Result } from "#workers/lanes/task";
import * as messages from "../messages";
import { toldOf } from "./told";

type Answer = Result<Tasks, "known">;

interface Known {
  moment: Moment;
  /** Null where the maps have no attractor, or cannot be had. */
  answer: Answer | null;
  none: boolean;
}

const known = signal<Known | null>(null);
/** Why a picture cannot be had, in words. */
export const directedProblem = signal<string | null>(null);

/** What is known of each state; null until it is. */
export const answerNow: ReadonlySignal<Answer | null> = computed(() => known.value?.answer ?? null);
/** Whether it is still about another moment. */
export const isStale: ReadonlySignal<boolean> = computed(
  () => known.value === null || known.value.moment !== directedMoment.value,
);

/** What is said where there is no attractor. */
export const NONE: Told = { verdict: "no-attractor", gap: { lower: 0, upper: 0 }, diameter: 0 };

const OPEN: Told = { verdict: "undecided", gap: { lower: 0, upper: 0 }, diameter: 1 };

/** What is known of a whole way. */
export interface WayFacts {
  way: Way;
  match: DirectedMatch | null;
  /** Why the graphs cannot be matched. */
  problem: string | null;
  proof: DirectedCertificate | null;
  /** Whether the linear way, where this is another one, is proved to stay in one piece. */
  linear: boolean;
  /** The search for a proof has ended without one, since there is a limit to it. */
  ended: boolean;
}

const found = signal<WayFacts | null>(null);

/** How the graphs are matched and what is shown of the whole way; null until something is known. */
export const wayFacts: ReadonlySignal<WayFacts | null> = computed(() =>
  found.value && found.value.way === directedWay.value ? found.value : null,
);

/** What is said of the shape at every moment of a way that is proved as it is; null where it is not. */
export const toldAlways: ReadonlySignal<Told | null> = computed(() => {
  const facts = wayFacts.value;
  if (!facts) return null;
  const [told] = toldOf([OPEN], { ...facts.way, t: 0.5 }, facts.way, facts.proof);
  return told?.verdict === "connected" ? told : null;
});

/** What is said of each state. */
export const toldStates: ReadonlySignal<readonly Told[]> = computed(() => {
  const now = known.value;
  const facts = wayFacts.value;
  const states = now?.answer?.states ?? [];
  return now && facts ? toldOf(states, now.moment, facts.way, facts.proof) : states;
});

/** What is said of the shape, its first state. */
export const toldNow: ReadonlySignal<Told | null> = computed(() =>
  known.value?.none ? NONE : (toldStates.value[0] ?? null),
);

/** The same in words: also that a part of it is in pieces, where the whole cannot be told. */
export const wordsNow: ReadonlySignal<VerdictWords> = computed(() => {
  const words = verdictWords(toldNow.value);
  return toldNow.value?.verdict === "undecided" && partApart.value
    ? { ...words, aside: messages.partInPieces(OWN_BOUNDS) }
    : words;
});

/** Whether something that the shape is made of is in pieces: the rest may hold it together all the same. */
const partApart = computed(() => {
  const unreached = known.value?.answer?.facts.unreached ?? [];
  return toldStates.value.some(({ verdict }, k) => verdict === "disconnected" && !unreached.includes(k));
});

/** A moment at which the shape is proved to be in pieces: the first of the film, or the present one. */
export const apartAt: ReadonlySignal<number | null> = computed(() => {
  const first = standInFilm.value.find(({ verdict }) => verdict?.verdict === "disconnected");
  const now = isStale.value || toldNow.value?.verdict !== "disconnected" ? null : directedMoment.value;
  return first?.t ?? now?.t ?? null;
});

/** The widest gap that the proof of a whole way asks about. */
const PROOF_EPSILON = 1 / 100;
/** It is not looked for any longer than this. */
const PROOF_MS = 30_000;
const REST_MS = 400;

/** Keeps all this up to date. Returns the end of it. */
export function watchKnown(): () => void {
  const end = new AbortController();
  const { signal: ended } = end;
  const turn = new InTurn();
  const stops = [
    effect(() => {
      const moment = directedMoment.value;
      if (!moment) return;
      turn.ask(async () => {
        try {
          const task = directedTask("known", { moment, epsilon: RESOLUTION }, { lane: 1, signal: ended });
          known.value = { moment, answer: await task, none: false };
        } catch (problem) {
          if (isStopped(problem)) return;
          const { code } = toError(problem);
          known.value = {
            moment,
            answer: null,
            none: code === "no-attractor" || code === "attractor-unproved",
          };
        }
      });
    }),
    effect(() => {
      const way = directedWay.value;
      if (!way) return;
      const own = new AbortController();
      const timer = setTimeout(() => void look(way, own.signal), REST_MS);
      return () => {
        clearTimeout(timer);
        own.abort();
      };
    }),
    effect(() => {
      standInWords.value = phraseOf(wordsNow.value);
    }),
  ];
  return () => {
    turn.clear();
    end.abort();
    for (const stop of stops) stop();
    known.value = null;
    found.value = null;
    standInWords.value = CURVES;
  };
}

async function look(way: Way, signal: AbortSignal): Promise<void> {
  const at = { lane: 2, signal } as const;
  try {
    const match = await directedTask("match", { from: way.from, to: way.to }, at);
    if (signal.aborted) return;
    const facts = { way, match, problem: null, proof: null, linear: false, ended: false };
    found.value = facts;
    const proof = await proofOf(way, signal);
    if (signal.aborted) return;
    found.value = { ...facts, proof, ended: proof === null };
    // Ends that meet stay together on straight lines: where a turn parts them, that may be better.
    if (way.mode === "linear" || proof?.states[0]?.kind === "connected") return;
    const straight = await proofOf({ ...way, mode: "linear" }, signal);
    const linear = straight?.states[0]?.kind === "connected" && straight.assuming.length === 0;
    if (!signal.aborted) found.value = { ...facts, proof, linear, ended: proof === null };
  } catch (problem) {
    if (!isStopped(problem) && !signal.aborted) {
      const none = { match: null, proof: null, linear: false, ended: true };
      found.value = { way, problem: wordsOf(problem), ...none };
    }
  }
}

/** What is proved of all of a way; null where that takes too long. */
async function proofOf(way: Way, signal: AbortSignal): Promise<DirectedCertificate | null> {
  const own = new AbortController();
  const end = () => own.abort();
  const timer = setTimeout(end, PROOF_MS);
  signal.addEventListener("abort", end);
  try {
    return await directedTask("certify", { ...way, epsilon: PROOF_EPSILON }, { lane: 2, signal: own.signal });
  } catch (problem) {
    if (isStopped(problem) && !signal.aborted) return null;
    throw problem;
  } finally {
    clearTimeout(timer);
    signal.removeEventListener("abort", end);
  }
}
