/**
 * The fit of the outline: the latest that was asked for, the best so far, its figures, and what it is compared with.
 */
import { batch, computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { polygonOf } from "#document/curve/polygon";
import { bytesOf, changeFit, fitDocument, replaceFit } from "#document/fit";
import { announce, notify, wordsOf } from "#document/notice";
import type { Curve, CurveShape, Fit, SplineShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import { fitTask } from "#workers/fit/client";
import type { Collage, CollageOptions, FitFigures, Method, PreparedOutline, Rival } from "#workers/fit/curve";
import { isStopped, Latest } from "#workers/lanes/latest";
import * as messages from "../messages";
import { polylineOf, prepared, reached, ready, SEEDS, sameCurve, upToDate } from "./outline";
import { cancelled, fail, problem, running, watched } from "./progress";
import { former, type Origin, plainName, type Source, source, takeFormer, takeSource } from "./source";
import { cameFrom, fitWithin, keepReached, sourceOf } from "./within";

export const LEAST_NUMBERS = 12;
export const MOST_NUMBERS = 2000;

export interface Best {
  of: PreparedOutline;
  /** What was asked for. */
  numbers: number;
  curve: Curve;
  points: Float64Array;
}

/** A fit as a link brings it back. Without figures where there is no outline to measure it by. */
export interface Fitted extends Best {
  figures: FitFigures | null;
  bytes: number;
}

export const best = signal<Best | null>(null);
export const fitted = signal<Fitted | null>(null);
const compared = signal<{
  of: PreparedOutline;
  numbers: number;
  list: readonly Rival[];
  whole: boolean;
} | null>(null);
export const collage = signal<{ of: PreparedOutline; options: CollageOptions; fit: Collage } | null>(null);
/** Milliseconds from the request to the first fit and to the last: for the measurements. */
export const clock = signal<{ first: number; whole: number }>({ first: 0, whole: 0 });

/** The paper's, of Fig 7. */
export const collageOptions = signal<CollageOptions>({
  maps: 29,
  features: 261,
  separable: false,
  tied: false,
  partitioned: false,
});

const METHODS: readonly Method[] = ["squares", "bezier", "split", "fourier", "collage"];

/** The numbers that a slider rests at before a fit is begun. */
const REST_MS = 140;

const latest = new Latest();
const cache = new WeakMap<PreparedOutline, Map<number, Fitted>>();
const comparisons = new WeakMap<PreparedOutline, Map<number, readonly Rival[]>>();
/** Curves that were fitted here: a document that holds another was opened from a link. */
const own = new WeakMap<Curve, { of: Source; fitted: Fitted | null }>();
/** What curves were fitted to that the shelf brings back. */
const origins = new WeakMap<Curve, Origin>();
/** The same of words. */
const wordOrigins = new Map<string, Origin>();

/** What is fitted, and into what. */
const wanted = computed(() => {
  const { model, numbers } = fitDocument.value;
  if (model === "spline") return JSON.stringify({ model, bytes: bytesOf(fitDocument.value) });
  return JSON.stringify(model === "closed" ? { model, numbers } : { model, ...collageOptions.value });
});

/** Keeps the fit up with the outline and what is asked for. Returns the end of it. */
export function watchFit(): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let seen: PreparedOutline | null = null;
  watched.value = true;
  const stopFit = effect(() => {
    const outline = prepared.value;
    wanted.value;
    if (timer) clearTimeout(timer);
    if (!outline) {
      latest.stop();
      running.value = null;
      return;
    }
    // A new outline is fitted at once; a slider is let come to rest.
    timer = setTimeout(() => begin(outline), seen === outline ? REST_MS : 0);
    seen = outline;
  });
  let shown: Curve | null = null;
  const stopLink = effect(() => {
    const shape = fitDocument.value.curve;
    if (!shape || shape.curve === shown) return;
    const { preset, name, curve } = shape;
    shown = curve;
    if (own.has(curve)) {
      untracked(() => backTo(own.get(curve)?.of));
      return;
    }
    // Those of the gallery have outlines, unless they are no more in it.
    if (preset === "sugar-maple" || preset === "white-oak" || preset === "island") {
      takeSource({ kind: "grown", name, grown: preset, seed: SEEDS[preset] });
    } else {
      const { numbers } = fitDocument.peek();
      takeSource({ kind: "kept", name, curve, word: null, numbers, origin: origins.get(curve) ?? null });
    }
    own.set(curve, { of: source.peek(), fitted: null });
  });
  let word: string | undefined;
  let first = true;
  const stopWord = effect(() => {
    const shape = fitDocument.value.spline;
    const again = !first;
    first = false;
    if (shape?.word === word) return;
    word = shape?.word;
    if (shape) untracked(() => takeWord(shape, again));
  });
  return () => {
    watched.value = false;
    stopFit();
    stopLink();
    stopWord();
    if (timer) clearTimeout(timer);
    // What is under way goes on: whoever comes back finds it done.
  };
}

/** A curve within bytes is there: a link or the shelf has brought it, or a step back or forth. */
function takeWord({ name, word }: SplineShape, again: boolean): void {
  const of = sourceOf(word);
  if (of && (of === source.peek() || !again)) {
    backTo(of);
    return;
  }
  if (of && of === former.peek()) {
    takeFormer();
    return;
  }
  // The picture of a photograph is gone by now.
  if (of && of.kind !== "picture") {
    takeSource(of);
    return;
  }
  try {
    const numbers = bytesOf(fitDocument.peek());
    const origin = wordOrigins.get(word) ?? null;
    takeSource({ kind: "kept", name, curve: polygonOf(word), word, numbers, origin });
    cameFrom(word, source.peek());
  } catch (wrong) {
    // Links are checked when they are read.
    fail(wrong);
  }
}

/** A fit of the shelf was opened, and that is undone or done again: what it was made from goes with it. */
function backTo(of: Source | undefined): void {
  const now = source.peek();
  if (!of || of === now || of !== former.peek()) return;
  if (of.kind === "kept" || now.kind === "kept") takeFormer();
}

/** Takes a fit that was kept into the document: one undo step, and nothing is fitted anew. */
export function openFit({ numbers, bytes, smoothing, curve, spline }: Fit, origin: Origin | null): void {
  if (curve && origin) origins.set(curve.curve, origin);
  if (spline && origin) wordOrigins.set(spline.word, origin);
  changeFit(({ curve: _curve, spline: _spline, bytes: _bytes, ...now }) => ({
    ...now,
    mode: "outline",
    model: spline ? "spline" : "closed",
    numbers,
    smoothing,
    ...(bytes !== undefined && { bytes }),
    ...(spline ? { spline } : curve && { curve }),
  }));
}

/** Begins anew, whatever was done before. */
export function fitAgain(): void {
  const outline = prepared.peek();
  if (!outline) return;
  cache.get(outline)?.delete(fitDocument.peek().numbers);
  begin(outline, true);
}

/** What is under way. */
let asked: { of: PreparedOutline; wanted: string } | null = null;

function begin(outline: PreparedOutline, again = false): void {
  // A document that was opened has its own curve, which is not to be overwritten.
  if (!upToDate()) return;
  if (!again && running.peek() && asked?.of === outline && asked.wanted === wanted.peek()) return;
  asked = { of: outline, wanted: wanted.peek() };
  const signal = latest.begin();
  const { model, numbers } = fitDocument.peek();
  problem.value = null;
  cancelled.value = false;
  if (model === "spline") {
    void fitWithin(outline, signal, again);
    return;
  }
  if (model === "collage") {
    void fitCollage(outline, { ...collageOptions.peek() }, signal);
    return;
  }
  const known =
    cache.get(outline)?.get(numbers) ??
    keptFit(outline, numbers) ??
    (again ? null : sameFit(outline, numbers));
  if (known) {
    batch(() => {
      best.value = known;
      fitted.value = known;
      running.value = null;
    });
    keep(known);
    if (known.figures) void compare(outline, numbers, signal);
    return;
  }
  const curve = ready.peek() ?? keptCurve(numbers);
  if (curve && !again)
    void measure({ of: outline, numbers, curve, points: polylineOf(curve) ?? new Float64Array() }, signal);
  else void fitCurve(outline, numbers, signal);
}

/** The figures of a fit that is there. */
async function measure(done: Best, signal: AbortSignal): Promise<void> {
  batch(() => {
    best.value = done;
    running.value = null;
  });
  try {
    const got = await fitTask("measure", { points: done.of.points, curve: done.curve });
    if (signal.aborted) return;
    finish({ ...done, ...got });
    await compare(done.of, done.numbers, signal);
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) fail(wrong);
  }
}

/** The curve of a link, as long as nothing else is asked for. */
function keptFit(outline: PreparedOutline, numbers: number): Fitted | null {
  const now = source.peek();
  if (now.kind !== "kept" || now.word !== null || now.numbers !== numbers || now.origin) return null;
  const { curve } = now;
  const points = polylineOf(curve);
  if (!points) return null;
  const { bytes } = rough.curveFacts(curve);
  return { of: outline, numbers, curve, points, figures: null, bytes };
}

/** The curve that was kept with its outline, as long as nothing else is asked for. */
function keptCurve(numbers: number): Curve | null {
  const now = source.peek();
  const asked =
    now.kind === "kept" && now.numbers === numbers && now.origin?.smoothing === fitDocument.peek().smoothing;
  return asked && now.word === null ? now.curve : null;
}

/** The fit of the document, where it was made here of the very same outline. */
function sameFit(outline: PreparedOutline, numbers: number): Fitted | null {
  const curve = fitDocument.peek().curve?.curve;
  const made = curve && own.get(curve)?.fitted;
  if (!made || made.numbers !== numbers || made.of.points.length !== outline.points.length) return null;
  return made.of.points.every((x, i) => x === outline.points[i]) ? { ...made, of: outline } : null;
}

async function fitCurve(outline: PreparedOutline, numbers: number, signal: AbortSignal): Promise<void> {
  const began = performance.now();
  let first = 0;
  running.value = { stage: "begin", share: 0 };
  try {
    const got = await fitTask(
      "fitCurve",
      { points: outline.points, numbers },
      {
        signal,
        onProgress: ({ stage, share, rms, curve, points }) => {
          if (signal.aborted) return;
          // What it is compared with hangs on the numbers alone.
          if (first === 0 && numbers <= SOON) void compare(outline, numbers, signal);
          first ||= performance.now() - began;
          batch(() => {
            running.value = { stage, share, rms };
            best.value = reached(best.peek(), { of: outline, numbers, curve, points });
          });
        },
      },
    );
    if (signal.aborted) return;
    const whole = performance.now() - began;
    clock.value = { first: first || whole, whole };
    if (numbers > SOON) void compare(outline, numbers, signal);
    finish({ of: outline, numbers, ...got });
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) fail(wrong);
  }
}

function finish(done: Fitted): void {
  put(cache, done.of, done.numbers, done);
  batch(() => {
    best.value = done;
    fitted.value = done;
    running.value = null;
  });
  keep(done);
  if (done.figures) announce(messages.fitted(done.figures.rms.toFixed(3)));
}

function put<T>(
  into: WeakMap<PreparedOutline, Map<number, T>>,
  of: PreparedOutline,
  numbers: number,
  what: T,
): void {
  into.set(of, (into.get(of) ?? new Map<number, T>()).set(numbers, what));
}

/** The last fit is part of the document, in place of one within bytes: a link opens it again. */
function keep(done: Fitted): void {
  const { curve } = done;
  if (!watched.peek()) return;
  const now = fitDocument.peek();
  // A link to a graph may have been followed meanwhile: it is not to be given a curve.
  if (now.mode !== "outline" || now.curve?.curve === curve) return;
  const shape = shapeOf(curve);
  own.set(shape.curve, { of: source.peek(), fitted: done });
  replaceFit(({ spline: _, ...now }) => ({ ...now, curve: shape }));
}

/** A fit as a shape: one of the gallery by its name there. */
export function shapeOf(curve: Curve): CurveShape {
  const now = source.peek();
  const preset = ready.peek();
  if (preset && now.kind === "grown" && sameCurve(preset, curve)) {
    return { preset: now.grown, name: plainName(now.name), curve: preset };
  }
  return { name: plainName(now.name), curve };
}

/**
 * What so many numbers are compared with is there in a second or two: beside the fit, which takes longer; else after
 * it.
 */
const SOON = 400;
const BESIDE = 1;

async function compare(of: PreparedOutline, numbers: number, signal: AbortSignal): Promise<void> {
  const known = comparisons.get(of)?.get(numbers);
  compared.value = { of, numbers, list: known ?? [], whole: known !== undefined };
  if (known) return;
  let list: readonly Rival[] = [];
  const onProgress = (rival: Rival) => {
    if (signal.aborted) return;
    list = [...list, rival];
    compared.value = { of, numbers, list, whole: false };
  };
  try {
    if (numbers > SOON) {
      await fitTask("rivals", { points: of.points, numbers, methods: METHODS }, { signal, onProgress });
    } else {
      // None is broken off: a worker that does not stop soon is ended, and the pictures in this one with it.
      for (const method of METHODS) {
        const args = { points: of.points, numbers, methods: [method] };
        await fitTask("rivals", args, { lane: BESIDE, onProgress });
        if (signal.aborted) return;
      }
    }
    if (signal.aborted) return;
    put(comparisons, of, numbers, list);
    compared.value = { of, numbers, list, whole: true };
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) notify({ kind: "error", text: wordsOf(wrong) });
  }
}

async function fitCollage(
  outline: PreparedOutline,
  options: CollageOptions,
  signal: AbortSignal,
): Promise<void> {
  running.value = { stage: "begin", share: 0 };
  try {
    const fit = await fitTask("collage", { points: outline.points, options }, { signal });
    if (signal.aborted) return;
    batch(() => {
      collage.value = { of: outline, options, fit };
      running.value = null;
    });
    announce(messages.fittedWith(options.maps, fit.figures.rms.toFixed(3)));
  } catch (wrong) {
    if (!signal.aborted && !isStopped(wrong)) fail(wrong);
  }
}

/** Stops the fit under way; the best so far is kept, and measured. */
export function cancel(): void {
  if (!running.peek()) return;
  const reached = best.peek();
  const signal = latest.begin();
  batch(() => {
    running.value = null;
    cancelled.value = true;
  });
  announce(messages.stoppedBestFitSo);
  if (fitDocument.peek().model === "spline") {
    void keepReached(signal);
    return;
  }
  if (reached && reached.of === prepared.peek()) void measure(reached, signal);
}

/** The fit that is on the stage, if it is one of the outline there. */
export const shownFit: ReadonlySignal<Best | null> = computed(() => {
  const now = best.value;
  return now && now.of === prepared.value ? now : null;
});

/** Other ways to spend as many numbers on it. */
export const rivals: ReadonlySignal<readonly Rival[]> = computed(() => {
  const now = compared.value;
  return now && now.of === prepared.value && now.numbers === fitted.value?.numbers ? now.list : [];
});

/** Whether no other is still being fitted: only then it is known which is the nearest. */
export const rivalsWhole: ReadonlySignal<boolean> = computed(() => compared.value?.whole ?? false);

export const shownFigures: ReadonlySignal<Fitted | null> = computed(() => {
  const now = fitted.value;
  return now && now.of === prepared.value ? now : null;
});
