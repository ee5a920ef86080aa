/** Which edge of the fit copies which arc, which of them is looked at, and how far the curve has grown. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import { significant } from "#format/significant";
import type { Curve } from "#wasm/api";
import { type CurveCopy, rough } from "#wasm/curve";
import * as messages from "../messages";
import { cutting } from "../stage/layers";
import { shownFit } from "../work/fitting";

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

// The edges of a curve as parts of its polyline. Points are x0, y0, x1, y1, ..

/** Where each edge begins in the polyline, and its number of points at the end; null where a knot is none of them. */
export function edgeStarts(
  points: ArrayLike<number>,
  knots: readonly (readonly [x: number, y: number])[],
): number[] | null {
  const count = points.length / 2;
  const starts: number[] = [];
  let at = 0;
  for (const [x, y] of knots) {
    while (at < count && (points[2 * at] !== x || points[2 * at + 1] !== y)) at++;
    if (at === count) return null;
    starts.push(at);
    at++;
  }
  return [...starts, count];
}

/** The points of so many edges from one on, to the knot where they end. */
export function edgePath(
  points: ArrayLike<number>,
  starts: readonly number[],
  from: number,
  span = 1,
): Float64Array {
  const edges = starts.length - 1;
  const path: number[] = [];
  for (let k = 0; k < span; k++) {
    const edge = (from + k) % edges;
    for (let i = starts[edge] ?? 0; i < (starts[edge + 1] ?? 0); i++) {
      path.push(points[2 * i] ?? 0, points[2 * i + 1] ?? 0);
    }
  }
  const end = starts[(from + span) % edges] ?? 0;
  path.push(points[2 * end] ?? 0, points[2 * end + 1] ?? 0);
  return Float64Array.from(path);
}

/** How far a point is from an open polyline. */
export function distanceTo(path: ArrayLike<number>, x: number, y: number): number {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i + 3 < path.length; i += 2) {
    const [ax, ay, bx, by] = [path[i] ?? 0, path[i + 1] ?? 0, path[i + 2] ?? 0, path[i + 3] ?? 0];
    const [dx, dy] = [bx - ax, by - ay];
    const size = dx * dx + dy * dy;
    const share = size > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / size)) : 0;
    least = Math.min(least, Math.hypot(x - ax - share * dx, y - ay - share * dy));
  }
  return least;
}

/** How an edge lies to the arc that it copies, in a sentence. */
export function copyWords({ span, ratio, across, degrees, mirrored }: CurveCopy): string {
  const parts = [messages.timesAsLong(significant(ratio, 2)), messages.timesAsHigh(significant(across, 2))];
  const turn = Math.round(Math.abs(degrees));
  if (turn === 180) parts.push(messages.rotatedByHalfTurn);
  else if (turn > 0)
    parts.push(messages.rotatedTo(turn, degrees > 0 ? messages.toTheLeft : messages.toTheRight));
  if (mirrored) parts.push(messages.mirroredToo);
  return messages.edgeCopies(span, parts.join(", "));
}

/** How far the curve has grown, in words. */
export function stepWords(steps: number | null): string {
  if (steps === null) return messages.allOfIt;
  if (steps === 0) return messages.polygonKnots;
  return `${steps} ${steps === 1 ? "step" : "steps"}`;
}
