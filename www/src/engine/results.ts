import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { pathPoints } from "../state/morph";
import type { Bounds, Connectedness, Locus, PathPlan, PathPoint, Verdict } from "./api";
import { breaksAlong, type Stretch, type Worst } from "./breaks";

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

/** A path, decided moment by moment: evenly spaced from 0 to 1. */
export interface Along {
  points: readonly PathPoint[];
  states: Uint8Array;
  breaks: Stretch[];
  worst: Worst | null;
}

/** Where the engine puts its answers. Views read the signals below. */
export const publish = {
  locus: signal<LocusResult | null>(null),
  verdict: signal<VerdictResult | null>(null),
  plan: signal<PathPlan | null>(null),
  strip: signal<Frame[]>([]),
  along: signal<Along | null>(null),
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

/** The present path, decided moment by moment; null until that answer is in. */
export const along: ReadonlySignal<Along | null> = computed(() => {
  const points = pathPoints.value;
  const found = publish.along.value;
  return found && found.points === points ? found : null;
});

/**
 * Broken stretches of the present path, in t. Decided sample by sample where that answer is in; until then read off the
 * locus field.
 */
export const pathBreaks: ReadonlySignal<Stretch[]> = computed(() => {
  const points = pathPoints.value;
  const exact = along.value;
  if (exact) return exact.breaks;
  const field = publish.locus.value;
  return field ? breaksAlong(field, points) : [];
});
