import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { pathPoints } from "../state/morph";
import type { Bounds, Connectedness, Locus, PathPlan, PathPoint, Verdict } from "./api";
import { breaksAlong, type Stretch } from "./breaks";

export interface LocusResult extends Locus {
  /** 0..1. Samples not yet decided have state 255 and gap NaN. */
  progress: number;
  bounds: Bounds;
}

export interface VerdictResult {
  connectedness: Connectedness;
  uv: PathPoint;
  /** The picture has moved on and the next answer is under way. */
  stale: boolean;
}

export interface Frame {
  t: number;
  verdict: Verdict | null;
  bitmap: ImageBitmap | null;
}

export interface WorkersState {
  count: number;
  busy: boolean;
  available: boolean;
}

/** Where the engine puts its answers. Views read the signals below. */
export const publish = {
  locus: signal<LocusResult | null>(null),
  verdict: signal<VerdictResult | null>(null),
  plan: signal<PathPlan | null>(null),
  strip: signal<Frame[]>([]),
  exactBreaks: signal<{ points: readonly PathPoint[]; breaks: Stretch[] } | null>(null),
  thumbnails: signal<Map<string, ImageBitmap>>(new Map()),
  workers: signal<WorkersState>({ count: 0, busy: false, available: true }),
};

/** The field over (u, v), a new object at each repaint. */
export const locus: ReadonlySignal<LocusResult | null> = publish.locus;
/** About what the stage shows. */
export const verdict: ReadonlySignal<VerdictResult | null> = publish.verdict;
/** The automatic path for the present pair. */
export const plan: ReadonlySignal<PathPlan | null> = publish.plan;
export const strip: ReadonlySignal<Frame[]> = publish.strip;
/** By preset id, and "a" and "b" for the two ends. */
export const thumbnails: ReadonlySignal<Map<string, ImageBitmap>> = publish.thumbnails;
export const workers: ReadonlySignal<WorkersState> = publish.workers;

/**
 * Broken stretches of the present path, in t. Decided sample by sample where that answer is in; until then read off the
 * locus field.
 */
export const pathBreaks: ReadonlySignal<Stretch[]> = computed(() => {
  const points = pathPoints.value;
  const exact = publish.exactBreaks.value;
  if (exact && exact.points === points) return exact.breaks;
  const field = publish.locus.value;
  return field ? breaksAlong(field, points) : [];
});
