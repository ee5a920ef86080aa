/** What hands and keys do to the path. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { along, locus, pathBreaks, verdict } from "#compute/results";
import { here, hold, locusView, pathPoints, uv } from "#document/morph";
import { announce } from "#document/notice";
import { setT } from "#document/playback";
import { edit, endGesture, scene } from "#document/scene";
import { fixed } from "#format/numbers";
import { type Told, toldOf, type VerdictWords, verdictPhrase, verdictWords } from "#format/verdict";
import { timesOf, type Uv } from "#geometry/path";
import { clamp, insert, move, nearestOn, remove } from "#geometry/polyline";
import { sampleNear } from "#geometry/states";
import type { Bounds } from "#wasm/api";
import { MOST_POINTS, setPoints } from "../../edits";
import * as messages from "../messages";

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

/** The waypoint whose numbers are shown; null where it is gone or none was picked. */
export const chosen: ReadonlySignal<number | null> = computed(() =>
  picked.value !== null && picked.value < way.value.length ? picked.value : null,
);

export function pick(index: number | null): void {
  picked.value = index;
}

/** What the field tells of a point; out of its plane it tells nothing. */
function toldAt(point: Uv): Told | null {
  const field = locus.value;
  if (field === null || (point[2] ?? 0) !== 0) return null;
  const { state, gap } = sampleNear(field, point);
  return toldOf(state, gap);
}

/** Whether the shape holds together at a point, as far as the field tells. */
export const stateAt = (point: Uv): string => verdictPhrase(toldAt(point));

/** Whether it holds together at the present moment of the path: what the stage says of it, once it does. */
export function stateNow(): string {
  const known = verdict.value;
  if (known && !known.stale && here.value === uv.value) return verdictPhrase(known.connectedness);
  const { t } = scene.value;
  const told = along.value?.told;
  return verdictPhrase(told?.[Math.round(t * (told.length - 1))] ?? toldAt(uv.value));
}

/** What the stage says of the shape at a point, where it is that which it shows. A proof holds for one parameter. */
export function toneAt(point: Uv): VerdictWords["tone"] | null {
  const known = verdict.value;
  if (!known || known.stale || known.uv !== point) return null;
  return verdictWords(known.connectedness, known.epsilon).tone;
}

/** What becomes of the path about a waypoint: whether it breaks there, before it, or after. */
export function wayWords(index: number): string {
  const told = along.value?.ways[index] ?? toldAt(way.value[index] ?? [0, 0]);
  const times = timesOf(pathPoints.value);
  const [before, at, after] = [times[index] ?? 0, times[index + 1] ?? 0, times[index + 2] ?? 1];
  const breaks = pathBreaks.value;
  const meets = (from: number, to: number) => breaks.some(({ t0, t1 }) => t0 < to && t1 > from);
  const words = [verdictPhrase(told)];
  if (meets(before, at)) words.push(messages.breaksOnPathBefore);
  if (meets(at, after)) words.push(words.length > 1 ? messages.andAfter : messages.breaksOnPathAfter);
  return words.join(", ").replace(", and", " and");
}

export const pointWords = ([u, v, w = 0]: Uv): string =>
  `u ${fixed(u)}, v ${fixed(v)}${w === 0 ? "" : `, w ${fixed(w)}`}`;

const asked = signal(false);

/** Whether waypoints show their third number: where one has it, and on request. */
export const thirdShown: ReadonlySignal<boolean> = computed(
  () => asked.value || way.value.some(([, , w]) => (w ?? 0) !== 0),
);

export function showW(): void {
  asked.value = true;
}

/** How far the stretch may be ahead of the turn, or behind it. */
export const MOST_W = 1;

/**
 * A point as the document keeps it: on the square, as fine as can be pointed at, and with as few numbers as it needs.
 */
function kept([u, v, w = 0]: Uv): Uv {
  const [x, y] = clamp([u, v], WHOLE);
  const digits = 10 ** (3 + Math.max(0, Math.ceil(Math.log10(locusView.peek().zoom))));
  const round = (z: number) => Math.round(z * digits) / digits || 0;
  const z = round(Math.min(MOST_W, Math.max(-MOST_W, w)));
  return z === 0 ? [round(x), round(y)] : [round(x), round(y), z];
}

function set(points: Uv[], gesture?: string): void {
  edit((before) => setPoints(before, points), gesture === undefined ? {} : { gesture });
}

/** Moves a waypoint; it stays on the square, and, where only u and v are given, at its own w. */
export function moveTo(index: number, point: Uv, gesture?: string): void {
  const [u, v, w = way.peek()[index]?.[2] ?? 0] = point;
  const to = kept([u, v, w]);
  if (gesture !== undefined) hold(to);
  set(move(way.peek(), index, to), gesture);
}

/**
 * A waypoint more, on the segment that is nearest; it lies in the plane that is looked at. Returns its number, or null
 * where a link could hold no more.
 */
export function addAt(point: Uv): number | null {
  if (way.peek().length >= MOST_POINTS) {
    announce(messages.mostWaypoints(MOST_POINTS));
    return null;
  }
  const { segment } = nearestOn(pathPoints.peek(), point);
  const [u, v, w = locusView.peek().w] = point;
  return addTo(segment, [u, v, w]);
}

/** A waypoint more, in the middle of the segment that starts at waypoint `index`; -1 is the first shape. */
export function addAfter(index: number): number | null {
  const from = pathPoints.peek()[index + 1];
  const to = pathPoints.peek()[index + 2];
  if (from === undefined || to === undefined || way.peek().length >= MOST_POINTS) return null;
  const w = ((from[2] ?? 0) + (to[2] ?? 0)) / 2;
  return addTo(index + 1, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, w]);
}

function addTo(segment: number, point: Uv): number {
  const at = kept(point);
  const before = uv.peek();
  endGesture();
  set(insert(way.peek(), segment, at));
  keepMoment(before);
  pick(segment);
  announce(messages.waypointAdded(segment + 1, way.peek().length, pointWords(at), stateAt(at)));
  return segment;
}

/** A waypoint more where the picture is now. */
export function addHere(): number | null {
  const [u, v, w = 0] = uv.peek();
  return addAt([u, v, w]);
}

export function removeAt(index: number): void {
  endGesture();
  set(remove(way.peek(), index));
  pick(null);
  announce(messages.waypointRemoved(index + 1, way.peek().length));
}

/** The moment is told by length along the path: after a change it is looked up anew, so that the picture stays. */
function keepMoment(before: Uv): void {
  const { t } = scene.peek();
  if (t > 0 && t < 1) setT(nearestOn(pathPoints.peek(), before).t);
}
