/** Which edge of the fit copies which arc, which of them is looked at, and how far the curve has grown. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import type { Curve } from "#wasm/api";
import { type CurveCopy, rough } from "#wasm/curve";
import { cutting } from "../stage/layers";
import { shownFit } from "../work/fitting";
import { distanceTo, edgePath, edgeStarts } from "./edges";

/** Steps that the slider reaches; further ones are too small to be seen. */
export const MOST_STEPS = 10;

export const copiesShown = signal(false);
/** The copy that was chosen last, from 0. */
const picked = signal(0);
/** Null is all of the curve. */
export const steps = signal<number | null>(null);

const curve: ReadonlySignal<Curve | null> = computed(() =>
  cutting.value || fitDocument.value.model !== "closed" ? null : (shownFit.value?.curve ?? null),
);

/** The copies of the curve on the stage, in the order of its edges. */
export const copies: ReadonlySignal<readonly CurveCopy[]> = computed(() => {
  const now = curve.value;
  try {
    return now ? rough.curveCopies(now) : [];
  } catch {
    return [];
  }
});

export const chosen: ReadonlySignal<number> = computed(() =>
  Math.max(0, Math.min(picked.value, copies.value.length - 1)),
);

export function choose(index: number): void {
  const count = copies.peek().length;
  if (count > 0) picked.value = ((Math.round(index) % count) + count) % count;
}

/** What is drawn of copies: a path for each of them, and one for the arc of the one that is looked at. */
export interface CopyPaths {
  edges: readonly Float64Array[];
  /** The same for those that copy one arc. */
  groups: readonly number[];
  chosen: number;
  arc: Float64Array;
}

const parts = computed(() => {
  const now = curve.value;
  const all = copies.value;
  if (!now || !copiesShown.value || steps.value !== null || all.length === 0) return null;
  const points = rough.curveSteps(now, MOST_STEPS);
  const starts = edgeStarts(points, now.knots);
  if (!starts) return null;
  const arcs = [...new Set(all.map(({ from, span }) => `${from} ${span}`))];
  return {
    points,
    starts,
    edges: all.map(({ edge }) => edgePath(points, starts, edge)),
    groups: all.map(({ from, span }) => arcs.indexOf(`${from} ${span}`)),
  };
});

export const copyPaths: ReadonlySignal<CopyPaths | null> = computed(() => {
  const now = parts.value;
  const copy = copies.value[chosen.value];
  if (!now || !copy) return null;
  const arc = edgePath(now.points, now.starts, copy.from, copy.span);
  return { edges: now.edges, groups: now.groups, chosen: chosen.value, arc };
});

/** The polyline of the curve as far as it has grown; null where all of it is shown. */
export const grown: ReadonlySignal<Float64Array | null> = computed(() => {
  const now = curve.value;
  if (!now || steps.value === null) return null;
  try {
    return rough.curveSteps(now, steps.value);
  } catch {
    return null;
  }
});

/** Looks at the copy that is nearest to a point of the plane, if one is as near as `reach`. */
export function chooseNear(x: number, y: number, reach: number): void {
  const now = parts.peek();
  if (!now) return;
  const distances = now.edges.map((path) => distanceTo(path, x, y));
  const least = Math.min(...distances);
  if (least <= reach) choose(distances.indexOf(least));
}
