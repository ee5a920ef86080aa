/** What hands and keys do to the path, and to the place on it. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { BOUNDS } from "#compute/locus/job";
import { announce } from "#document/notice";
import { endGesture } from "#document/scene";
import { changeSpace, setMorphTime } from "#document/space/edits";
import { fixed } from "#format/numbers";
import { type Told, toldOf, verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { clamp, insert, move, nearestOn, remove } from "#geometry/polyline";
import { sampleNear } from "#geometry/states";
import type { PathKind, PathPoint, Space } from "#wasm/api";
import * as messages from "../messages";
import { MOST_POINTS, withPath } from "./morph-edits";
import { check, judged, locus, moment, pathPoints, uv } from "./work";

/** Points between the two ends. */
export const way: ReadonlySignal<Uv[]> = computed(() => pathPoints.value.slice(1, -1));

const picked = signal<number | null>(null);
/** The waypoint whose numbers are shown. */
export const chosen: ReadonlySignal<number | null> = computed(() =>
  picked.value !== null && picked.value < way.value.length ? picked.value : null,
);
export function pick(index: number | null): void {
  picked.value = index;
}

/** Where a point lies on the square: parts from its left and from its top. */
export function place([u, v]: Readonly<Uv>): [x: number, y: number] {
  return [(u - BOUNDS.u0) / (BOUNDS.u1 - BOUNDS.u0), (BOUNDS.v1 - v) / (BOUNDS.v1 - BOUNDS.v0)];
}

/** What the map tells of a point. */
function toldAt(point: Uv): Told | null {
  const field = locus.value;
  if (!field) return null;
  const { state, gap } = sampleNear({ ...field, bounds: BOUNDS }, point);
  return toldOf(state, gap);
}

/** Whether the shape holds together at a waypoint: looked at there, or read off the map until that is in. */
export const stateAt = (index: number): string =>
  verdictPhrase(check.value?.ways[index] ?? toldAt(way.value[index] ?? [0, 0]));

/** The same at the present moment: what is said of the picture, once that is in. */
export function stateNow(): string {
  const known = judged.value;
  if (known && !known.stale) return verdictPhrase(known.answer);
  const told = check.value?.told;
  return verdictPhrase(told?.[Math.round(moment.value * (told.length - 1))] ?? toldAt(uv.value));
}

export const pointWords = ([u, v]: Readonly<Uv>): string => `u ${fixed(u)}, v ${fixed(v)}`;

const rounded = (x: number, digits: number) => Math.round(x * 10 ** digits) / 10 ** digits || 0;

/** A point as the document keeps it: on the square, and as fine as can be pointed at. */
function kept(point: Uv): PathPoint {
  const [u, v] = clamp(point, BOUNDS);
  return [rounded(u, 3), rounded(v, 3)];
}

const drawn = (space: Space, points: PathPoint[]) => withPath(space, { kind: "drawn", points });

export function moveTo(index: number, point: Uv, gesture: string): void {
  changeSpace((now) => drawn(now, move(way.peek(), index, kept(point))), { gesture });
}

/** A waypoint more, on the stretch that is nearest. Returns its number, or null where a link could hold no more. */
export function addAt(point: Uv): number | null {
  return addTo(nearestOn(pathPoints.peek(), point).segment, point);
}

/** A waypoint more where the picture is now. */
export function addHere(): number | null {
  return addAt(uv.peek());
}

/** A waypoint more, in the middle of the stretch behind waypoint `index`. */
export function addAfter(index: number): number | null {
  const [from, to] = [pathPoints.peek()[index + 1], pathPoints.peek()[index + 2]];
  return from && to ? addTo(index + 1, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]) : null;
}

function addTo(segment: number, point: Uv): number | null {
  if (way.peek().length >= MOST_POINTS) {
    announce(messages.mostWaypoints(MOST_POINTS));
    return null;
  }
  const before = uv.peek();
  const at = kept(point);
  endGesture();
  if (!changeSpace((now) => staying(drawn(now, insert(way.peek(), segment, at)), before))) return null;
  pick(segment);
  announce(messages.waypointAdded(segment + 1, way.peek().length, pointWords(at)));
  return segment;
}

export function removeAt(index: number): void {
  const before = uv.peek();
  endGesture();
  if (!changeSpace((now) => staying(drawn(now, remove(way.peek(), index)), before))) return;
  pick(null);
  announce(messages.waypointRemoved(index + 1, way.peek().length));
}

/** The moment is told by length along the path: after a change it is looked up anew, so that the picture stays. */
function staying(now: Space, before: Uv): Space {
  const { morph } = now;
  if (!morph || morph.t <= 0 || morph.t >= 1) return now;
  const points: Uv[] = [[0, 0], ...morph.path.points, [1, 1]];
  return { ...now, morph: { ...morph, t: rounded(nearestOn(points, before).t, 4) } };
}

export function setKind(kind: PathKind): void {
  changeSpace((now) => {
    if (!now.morph || now.morph.path.kind === kind) return now;
    // What is drawn begins with what is there; what is found is looked for anew.
    return withPath(now, { kind, points: kind === "drawn" ? now.morph.path.points : [] });
  });
  pick(null);
}

/** Goes to a place on the path. */
export function goTo(t: number): void {
  const clamped = Number.isFinite(t) ? Math.min(1, Math.max(0, t)) : 0;
  setMorphTime(rounded(clamped, 4), { gesture: "morph-t" });
}
