/** The fit by corners and parabolas within so many bytes: the best so far, and what it is compared with. */
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { polygonOf } from "#document/curve/polygon";
import { bytesOf, fitDocument, replaceFit } from "#document/fit";
import { announce, notify, wordsOf } from "#document/notice";
import type { CurveShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import { fitTask } from "#workers/fit/client";
import type { ByteMethod, ByteRival, FitFigures, PreparedOutline, SplineMeasured } from "#workers/fit/curve";
import { isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { prepared } from "./outline";
import { fail, problem, running, watched } from "./progress";
import { plainName, type Source, source } from "./source";

/** A curve that is there, packed in letters, and how many bytes it was to take. */
export interface Within {
  of: PreparedOutline;
  asked: number;
  word: string;
  points: Float64Array;
}

/** One that is done. Without figures where there is no outline to measure it by. */
export interface WithinDone extends Within {
  /** How many it takes. */
  bytes: number;
  corners: number;
  bends: number;
  figures: FitFigures | null;
}

const reached = signal<Within | null>(null);
const finished = signal<WithinDone | null>(null);
const compared = signal<{
  of: PreparedOutline;
  asked: number;
  list: readonly ByteRival[];
  whole: boolean;
} | null>(null);

const METHODS: readonly ByteMethod[] = ["squares", "bezier", "fourier"];
/** Not the worker that fits. */
const BESIDE = 1;

const cache = new WeakMap<PreparedOutline, Map<number, WithinDone>>();
const comparisons = new WeakMap<PreparedOutline, Map<number, readonly ByteRival[]>>();
/** Curves that were fitted here or came before: what they were made from. */
const own = new Map<string, { of: Source; done: WithinDone | null }>();

/** What the curve of a word was made from, if that is known here. */
export const sourceOf = (word: string): Source | null => own.get(word)?.of ?? null;
/** The document has brought a curve, and this is what it is made from. */
export const cameFrom = (word: string, of: Source): void => note(word, of, null);

/** So many are remembered. */
const MOST_OWN = 24;

function note(word: string, of: Source, done: WithinDone | null): void {
  own.delete(word);
  own.set(word, { of, done });
  for (const old of own.keys()) {
    if (own.size <= MOST_OWN) break;
    own.delete(old);
  }
}

/** The fit on the stage, if it is one of the outline there. */
export const shownWithin: ReadonlySignal<Within | null> = computed(() => {
  const now = reached.value;
  return now && now.of === prepared.value ? now : null;
});

export const withinDone: ReadonlySignal<WithinDone | null> = computed(() => {
  const now = finished.value;
  return now && now.of === prepared.value ? now : null;
});

/** Other ways to spend as many bytes on it; null while some are still looked for. */
export const byteRivals: ReadonlySignal<readonly ByteRival[] | null> = computed(() => {
  const now = compared.value;
  return now?.whole && now.of === prepared.value && now.asked === withinDone.value?.asked ? now.list : null;
});

/** The corners and control points of a curve, x0, y0, .. */
export function nodesOf(word: string): Float64Array {
  return Float64Array.from(rough.unpackSpline(word).nodes.flatMap(({ at }) => [...at]));
}

/** The curve as a shape for the morph and the grid. */
export const polygonShape = (word: string): CurveShape => ({
  name: plainName(source.peek().name),
  curve: polygonOf(word),
  spline: word,
});

/** What is there without fitting: found before, or brought by the document. */
function known(outline: PreparedOutline, asked: number): WithinDone | null {
  const before = cache.get(outline)?.get(asked);
  if (before) return before;
  const word = fitDocument.peek().spline?.word;
  const made = word === undefined ? null : own.get(word)?.done;
  if (!made || made.asked !== asked || made.of.points.length !== outline.points.length) return null;
  return made.of.points.every((x, i) => x === outline.points[i]) ? { ...made, of: outline } : null;
}

/** The curve of a link or of the shelf, as long as nothing else is asked for. */
function brought(asked: number): { word: string; measurable: boolean } | null {
  const now = source.peek();
  if (now.kind !== "kept" || now.word === null || now.numbers !== asked) return null;
  if (!now.origin) return { word: now.word, measurable: false };
  return now.origin.smoothing === fitDocument.peek().smoothing ? { word: now.word, measurable: true } : null;
}

/** Fits the outline, or takes what is there. */
export async function fitWithin(
  outline: PreparedOutline,
  signal: AbortSignal,
  again: boolean,
): Promise<void> {
  const asked = bytesOf(fitDocument.peek());
  if (again) cache.get(outline)?.delete(asked);
  try {
    const there = again ? null : known(outline, asked);
    const kept = again ? null : brought(asked);
    if (there) {
      finish(there);
    } else if (kept && !kept.measurable) {
      finish(unmeasured(outline, asked, kept.word));
      return;
    } else if (kept) {
      await measureWithin(outline, asked, kept.word, signal);
    } else {
      running.value = { stage: "begin", share: 0 };
      const args = { points: outline.points, bytes: asked };
      const got = await fitTask("fitWithin", args, {
        signal,
        onProgress: (told) => {
          if (signal.aborted) return;
          batch(() => {
            const rms = "rms" in told ? told.rms : running.peek()?.rms;
            running.value = { stage: "polish", share: told.share, rms: rms ?? null };
            if ("word" in told) reached.value = { of: outline, asked, word: told.word, points: told.points };
          });
        },
      });
      if (signal.aborted) return;
      finish(of(outline, asked, got));
    }
    await compare(outline, asked, signal);
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) fail(wrong);
  }
}

const of = (outline: PreparedOutline, asked: number, got: SplineMeasured): WithinDone => ({
  ...got,
  of: outline,
  asked,
  bytes: got.bytes.length,
});

function unmeasured(outline: PreparedOutline, asked: number, word: string): WithinDone {
  const { nodes, points, bytes } = rough.unpackSpline(word);
  const corners = nodes.filter(({ on }) => on).length;
  return { of: outline, asked, word, points, bytes, corners, bends: nodes.length - corners, figures: null };
}

/** The figures of a curve that is there. */
async function measureWithin(
  outline: PreparedOutline,
  asked: number,
  word: string,
  signal: AbortSignal,
): Promise<void> {
  const got = await fitTask("measureSpline", { points: outline.points, word }, { signal });
  if (!signal.aborted) finish(of(outline, asked, got));
}

/** It was stopped: the best so far is measured, and kept. */
export async function keepReached(signal: AbortSignal): Promise<void> {
  const now = shownWithin.peek();
  // Of fewer or more bytes it is not what was asked for.
  if (now?.asked !== bytesOf(fitDocument.peek())) return;
  try {
    await measureWithin(now.of, now.asked, now.word, signal);
    // The next time it is asked for, it is looked for again.
    cache.get(now.of)?.delete(now.asked);
    if (!signal.aborted) await compare(now.of, now.asked, signal);
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) fail(wrong);
  }
}

function finish(done: WithinDone): void {
  cache.set(done.of, (cache.get(done.of) ?? new Map<number, WithinDone>()).set(done.asked, done));
  batch(() => {
    reached.value = done;
    finished.value = done;
    running.value = null;
    problem.value = null;
  });
  keep(done);
  if (done.figures) announce(messages.fittedWithin(done.bytes, done.figures.rms.toFixed(3)));
}

/** The last fit is part of the document, in place of one by a closed curve: a link opens it again, and stays short. */
function keep(done: WithinDone): void {
  if (!watched.peek()) return;
  const now = fitDocument.peek();
  if (now.mode !== "outline" || now.model !== "spline") return;
  const { word } = done;
  note(word, source.peek(), done);
  if (now.spline?.word === word && !now.curve) return;
  replaceFit(({ curve: _, ...rest }) => ({
    ...rest,
    spline: now.spline?.word === word ? now.spline : { name: plainName(source.peek().name), word },
  }));
}

/** Looks for the others, each when the worker beside has time. */
async function compare(outline: PreparedOutline, asked: number, signal: AbortSignal): Promise<void> {
  const before = comparisons.get(outline)?.get(asked);
  compared.value = { of: outline, asked, list: before ?? [], whole: before !== undefined };
  if (before) return;
  const list: ByteRival[] = [];
  try {
    for (const method of METHODS) {
      // None is broken off: a worker that does not stop soon is ended, and the pictures in this one with it.
      const args = { points: outline.points, method, bytes: asked };
      const got = await fitTask("rivalWithin", args, { lane: BESIDE });
      if (signal.aborted) return;
      if (got) list.push(got);
    }
    comparisons.set(outline, (comparisons.get(outline) ?? new Map()).set(asked, list));
    compared.value = { of: outline, asked, list, whole: true };
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) notify({ kind: "error", text: wordsOf(wrong) });
  }
}
