/** What jobs have found, for all who show it. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { pathPoints } from "#document/morph";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import type { Told } from "#format/verdict";
import { type Stretch, statesAlong, stretches, type Worst } from "#geometry/states";
import type { Bounds, Connectedness, Locus, PathPlan, PathPoint } from "#wasm/api";
import type { Pyramid } from "./locus/pyramid";

export interface LocusResult extends Locus {
  /** 0..1. Samples not yet decided have state 255 and gap NaN. */
  progress: number;
  bounds: Bounds;
}

/** What is known of the plane that is looked at; a new object at each repaint. */
interface WindowResult {
  pyramid: Pyramid;
  /** 0..1, of the window. */
  progress: number;
  /** Why there is nothing to see, in a sentence. */
  problem: string | null;
}

interface VerdictResult {
  connectedness: Connectedness;
  /** What it was looked at with. */
  epsilon: number;
  uv: PathPoint;
  /** Formulas that entries of the maps mean, where it is about these and not about doubles. */
  numbers?: readonly string[];
  /** What it was looked at with, where that was closer. */
  closer?: number;
  /** The picture has moved on and the next answer is under way. */
  stale: boolean;
}

export interface Frame {
  t: number;
  verdict: Told | null;
  bitmap: ImageBitmap | null;
  /** The picture is of what was there before, and the next one is under way. */
  stale: boolean;
}

/**
 * A still that is to be made anew. Of other shapes it shows nothing until there is a picture of them; what is known of
 * it holds where only colours have changed.
 */
export const outdated = ({ t, bitmap, verdict }: Frame, others: boolean, coloured = false): Frame => ({
  t,
  verdict: coloured ? verdict : null,
  bitmap: others ? null : bitmap,
  stale: true,
});

/** A path, decided moment by moment: evenly spaced from 0 to 1. */
export interface Along {
  points: readonly PathPoint[];
  states: Uint8Array;
  /** What is said of each moment. */
  told: readonly (Told | null)[];
  /** What is said of each point between the ends. */
  ways: readonly (Told | null)[];
  breaks: Stretch[];
  worst: Worst | null;
}

/** Where the jobs of this room put their answers. Views read the signals below. */
export const publish = {
  locus: signal<LocusResult | null>(null),
  window: signal<WindowResult | null>(null),
  verdict: signal<VerdictResult | null>(null),
  plan: signal<PathPlan | null>(null),
  sought: signal(false),
  promised: signal(false),
  strip: signal<Frame[]>([]),
  standInFilm: signal<readonly Frame[]>([]),
  along: signal<Along | null>(null),
  thumbnails: signal<Map<string, ImageBitmap>>(new Map()),
};

/** The field over all of (u, v), in the plane of Burch and Hart; a new object at each repaint. */
export const locus: ReadonlySignal<LocusResult | null> = publish.locus;
/** The field that the locus view shows. */
export const locusWindow: ReadonlySignal<WindowResult | null> = publish.window;
/** About what the stage shows. */
export const verdict: ReadonlySignal<VerdictResult | null> = publish.verdict;
/** The automatic path for the present pair. */
export const plan: ReadonlySignal<PathPlan | null> = publish.plan;
/** Whether the automatic path is still looked for, or another that is known to hold, and one stands in its place. */
export const sought: ReadonlySignal<boolean> = computed(
  () => !standIn.value && (publish.sought.value || publish.promised.value),
);
export const strip: ReadonlySignal<Frame[]> = publish.strip;
/** Stills of the morph of what stands in place of the systems, at even times. */
export const standInFilm: ReadonlySignal<readonly Frame[]> = publish.standInFilm;
/** By preset id, and "a" and "b" for the two ends. */
export const thumbnails: ReadonlySignal<Map<string, ImageBitmap>> = publish.thumbnails;

/** The present path, decided moment by moment; null until that answer is in. */
export const along: ReadonlySignal<Along | null> = computed(() => {
  const points = pathPoints.value;
  const found = publish.along.value;
  return found && found.points === points ? found : null;
});

/**
 * The states of even moments of the present path. Decided one by one where that answer is in; until then read off the
 * locus field.
 */
export const pathStates: ReadonlySignal<Uint8Array> = computed(() => {
  const points = pathPoints.value;
  const exact = along.value;
  if (exact) return exact.states;
  const field = publish.locus.value;
  return field ? statesAlong(field, points) : new Uint8Array();
});

/** Stretches of the present path, in t, where it is broken for all to see; none of one that only stands in. */
export const pathBreaks: ReadonlySignal<Stretch[]> = computed(() =>
  sought.value ? [] : (along.value?.breaks ?? stretches(pathStates.value)),
);

/** Whether the automatic path of the present pair is known to break, as far as this square goes. */
export const stuck: ReadonlySignal<boolean> = computed(() => {
  const exact = along.value;
  return (
    scene.value.path.kind === "auto" &&
    publish.plan.value?.holds === false &&
    exact !== null &&
    exact.breaks.length > 0 &&
    publish.locus.value?.progress === 1
  );
});
