/** What hands and keys do to the path. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Bounds } from "../../../engine/api";
import { stateNear } from "../../../engine/breaks";
import { locus } from "../../../engine/results";
import { pathPoints, uv } from "../../../state/morph";
import { announce } from "../../../state/notice";
import type { Uv } from "../../../state/path";
import { setT } from "../../../state/playback";
import { edit, endGesture, scene } from "../../../state/scene";
import { fixed } from "../../../ui/number";
import { MOST_POINTS, setPoints } from "../changes";
import { stateWords } from "../words";
import { clamp, insert, move, nearestOn, remove, rounded } from "./polyline";

/** The part of the (u, v) plane that is shown before the engine has said so. */
const WHOLE: Bounds = { u0: -1, v0: -1, u1: 2, v1: 2 };

export const bounds: ReadonlySignal<Bounds> = computed(() => locus.value?.bounds ?? WHOLE);

/** Points between the two ends. */
export const way: ReadonlySignal<Uv[]> = computed(() => pathPoints.value.slice(1, -1));

/** Where a point lies on the square that is shown: fractions from its left and from its top. */
export function place([u, v]: Uv, { u0, v0, u1, v1 }: Bounds): [x: number, y: number] {
  return [(u - u0) / (u1 - u0), (v1 - v) / (v1 - v0)];
}

const picked = signal<number | null>(null);

/** The way point whose numbers are shown; null where it is gone or none was picked. */
export const chosen: ReadonlySignal<number | null> = computed(() =>
  picked.value !== null && picked.value < way.value.length ? picked.value : null,
);

export function pick(index: number | null): void {
  picked.value = index;
}

/** Whether the shape holds together at a point, as far as the field tells. */
export function stateAt(point: Uv): string {
  const field = locus.value;
  return field === null ? stateWords(255) : stateWords(stateNear(field, point));
}

export const pointWords = ([u, v]: Uv): string => `u ${fixed(u)}, v ${fixed(v)}`;

function set(points: Uv[], gesture?: string): void {
  edit((before) => setPoints(before, points), gesture === undefined ? {} : { gesture });
}

/** Moves a way point; it stays on the square. */
export function moveTo(index: number, point: Uv, gesture?: string): void {
  set(move(way.peek(), index, rounded(clamp(point, bounds.peek()))), gesture);
}

/** A way point more, on the segment that is nearest. Returns its number, or null where a link could hold no more. */
export function addAt(point: Uv): number | null {
  if (way.peek().length >= MOST_POINTS) {
    announce(`A path has at most ${MOST_POINTS} way points.`);
    return null;
  }
  const { segment } = nearestOn(pathPoints.peek(), point);
  return addTo(segment, point);
}

/** A way point more, in the middle of the segment that starts at way point `index`; -1 is the first shape. */
export function addAfter(index: number): number | null {
  const from = pathPoints.peek()[index + 1];
  const to = pathPoints.peek()[index + 2];
  if (from === undefined || to === undefined || way.peek().length >= MOST_POINTS) return null;
  return addTo(index + 1, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
}

function addTo(segment: number, point: Uv): number {
  const at = rounded(clamp(point, bounds.peek()));
  const before = uv.peek();
  endGesture();
  set(insert(way.peek(), segment, at));
  keepMoment(before);
  pick(segment);
  announce(`Way point ${segment + 1} of ${way.peek().length} added at ${pointWords(at)}, ${stateAt(at)}.`);
  return segment;
}

/** A way point more where the picture is now. */
export function addHere(): number | null {
  return addAt(uv.peek());
}

export function removeAt(index: number): void {
  endGesture();
  set(remove(way.peek(), index));
  pick(null);
  announce(`Way point ${index + 1} removed, ${way.peek().length} left.`);
}

/** The moment is told by length along the path: after a change it is looked up anew, so that the picture stays. */
function keepMoment(before: Uv): void {
  const { t } = scene.peek();
  if (t > 0 && t < 1) setT(nearestOn(pathPoints.peek(), before).t);
}
