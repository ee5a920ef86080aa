/** The outline that is fitted: of the source, in units of the plane, smoothed as the document says. */

import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import type { Curve, CurvePreset } from "#wasm/api";
import { rough } from "#wasm/curve";
import { fitTask } from "#workers/fit/client";
import type { PreparedOutline } from "#workers/fit/curve";
import { InTurn, isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { traced } from "./mask";
import {
  boxOf,
  chooseOutline,
  former,
  framed,
  frameOfPoints,
  frameOfSize,
  PLAIN,
  type Source,
  source,
  takeFormer,
} from "./source";

/** How far the polyline of a curve may be from it where it stands for its outline, in parts of its size. */
const FINE = 5e-4;

const grown = signal<{ of: Source; points: Float64Array } | null>(null);

/** All points of the source, or null while they are not there. */
export const raw: ReadonlySignal<Float64Array | null> = computed(() => {
  const now = source.value;
  switch (now.kind) {
    case "grown":
      return grown.value?.of === now ? grown.value.points : null;
    case "picture":
      return traced.value;
    case "outlines": {
      const points = now.outlines[now.chosen]?.points;
      // All outlines of a file keep their places: the first is the largest.
      const first = now.outlines[0]?.points;
      return points && first ? framed(points, frameOfPoints(first)) : null;
    }
    case "kept":
      return now.origin?.outline ?? keptPoints.value;
  }
});

/** Once for each source: the polyline of one curve is one outline. */
const keptPoints = computed(() => {
  const now = source.value;
  return now.kind === "kept" ? polylineOf(now.curve) : null;
});

/** A curve as a polyline, fine enough to stand for an outline. */
export function polylineOf(curve: Curve): Float64Array | null {
  try {
    const handle = new rough.CurveMorph(curve, null);
    const [x0, y0, x1, y1] = handle.bounds(0);
    const points = handle.polyline(0, { tolerance: FINE * Math.max(x1 - x0, y1 - y0) });
    handle.free();
    return points;
  } catch {
    return null;
  }
}

/** Seeds of the leaves that the gallery has fits of. */
export const SEEDS = { "sugar-maple": 1, "white-oak": 1, island: 4, noisy: 1 } as const;

let gallery: readonly CurvePreset[] | null = null;

/** A fit that is there before anything is worked out: the gallery's, of an outline that is as it was grown. */
export const ready: ReadonlySignal<Curve | null> = computed(() => {
  const now = source.value;
  const { model, smoothing, numbers } = fitDocument.value;
  if (now.kind !== "grown" || now.seed !== SEEDS[now.grown] || model !== "closed" || smoothing !== 0)
    return null;
  try {
    gallery ??= rough.curvePresets();
    const curve = gallery.find(({ id }) => id === now.grown)?.curve;
    return curve && Math.abs(numbersOf(curve) - numbers) <= 2 ? curve : null;
  } catch {
    return null;
  }
});

/** How many numbers a curve is made of. */
export function numbersOf(curve: Curve): number {
  return 2 * (curve.knots.length + curve.edges.filter((edge) => edge !== null).length);
}

/** What is fitted now. */
export const prepared = signal<PreparedOutline | null>(null);
/** Where it lies: what the stage fits. */
export const outlineBox = computed(() => {
  const points = prepared.value?.points ?? raw.value;
  if (points) return boxOf(points);
  return ready.value && boxOf(new Float64Array(ready.value.knots.flat()));
});

/** Units of the plane a unit of the source, and where its origin lies. */
export const frame = computed(() => {
  const now = source.value;
  if (now.kind === "picture") return frameOfSize(now.picture.width, now.picture.height);
  if (now.kind === "outlines" && now.outlines[0]) return frameOfPoints(now.outlines[0].points);
  return PLAIN;
});

/** Not that of the fits: these take seconds. */
const OUTLINE_LANE = 1;

const turn = new InTurn();
let last: { raw: Float64Array; smoothing: number } | null = null;

/** Keeps what is fitted up with the source and the smoothing. Returns the end of it. */
export function watchOutline(): () => void {
  const stopGrowing = effect(() => {
    const now = source.value;
    if (now.kind !== "grown" || grown.peek()?.of === now) return;
    fitTask("grow", { kind: now.grown, seed: now.seed }, { lane: OUTLINE_LANE }).then(
      (points) => {
        if (source.peek() === now) grown.value = { of: now, points };
      },
      (problem) => {
        if (!isStopped(problem)) notify({ kind: "error", text: wordsOf(problem) });
      },
    );
  });
  const smoothing = computed(() => fitDocument.value.smoothing);
  const stopPreparing = effect(() => {
    const points = raw.value;
    const much = smoothing.value;
    if (!points) {
      turn.clear();
      last = null;
      prepared.value = null;
      return;
    }
    if (last && last.raw === points && last.smoothing === much) return;
    turn.ask(() => prepare(points, much));
  });
  return () => {
    stopGrowing();
    stopPreparing();
  };
}

/** Whether what is fitted is what the source has now: another may be on its way. */
export const upToDate = (): boolean => last !== null && last.raw === raw.peek();

async function prepare(points: Float64Array, smoothing: number): Promise<void> {
  try {
    const got = await fitTask("prepare", { points, smoothing }, { lane: OUTLINE_LANE });
    if (raw.peek() !== points) return;
    last = { raw: points, smoothing };
    prepared.value = got;
  } catch (problem) {
    if (raw.peek() !== points || isStopped(problem)) return;
    const back = former.peek();
    const now = source.peek();
    notify({
      kind: "error",
      text: messages.outlineNotFitted(wordsOf(problem)),
      ...(back && now.kind !== "picture"
        ? { action: { label: messages.backTo(back.name), run: takeFormer } }
        : {}),
    });
    if (now.kind === "outlines" && now.chosen !== 0) chooseOutline(0);
  }
}

// Curves come from the worker anew at each step of progress, whether they are better or not.

export function sameCurve(a: Curve, b: Curve): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}

/** What is reached: the one before where the next is the same, so that whoever draws it has nothing to do. */
export function reached<T extends { of: unknown; numbers: number; curve: Curve }>(
  last: T | null,
  next: T,
): T {
  if (last === null || last.of !== next.of || last.numbers !== next.numbers) return next;
  return sameCurve(last.curve, next.curve) ? last : next;
}
