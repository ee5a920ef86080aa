/** What the stage shows: its frame, and the graph as a polyline as fine as it is seen. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { inGesture } from "#document/scene";
import { attachPanZoom, type PanZoom, panZoomKey } from "#ui/panZoom";
import { rough } from "#wasm/curve";
import { chosen, copying, current, found, mapOf, picks, search } from "../find/search";
import { graph, model, value } from "../model/document";
import { errorsOf, interval } from "../model/model";
import { series, sets, unmade } from "../model/series";
import { aired, type Frame, heights, leftOf, tAt } from "./frame";
import type { Copy } from "./paint";

// Which part of t the stage shows.

type Span = readonly [from: number, to: number];

/** How much is free beside the whole, in its parts. */
const FREE_MARGIN = 0.04;
const MOST_ZOOM = 1e9;
const LEAST_ZOOM = 1 / 4;

/** Null shows all. */
const chosenSpan = signal<Span | null>(null);

/** All of the graph and of what is measured. */
const whole: ReadonlySignal<Span> = computed(() => {
  const points = series.value?.points;
  const drawn = unmade.value ? null : interval(model.value.knots);
  const measured = points ? [points[0] ?? 0, points[points.length - 2] ?? 1] : null;
  const ends = [drawn, measured].flatMap((pair) => pair ?? []);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const edge = FREE_MARGIN * (high - low);
  return [low - edge, high + edge];
});

const span: ReadonlySignal<Span> = computed(() => chosenSpan.value ?? whole.value);

/** How much larger than the whole it is shown. */
export const magnified: ReadonlySignal<number> = computed(() => {
  const [all, now] = [whole.value, span.value];
  return (all[1] - all[0]) / (now[1] - now[0]);
});

export function showAll(): void {
  chosenSpan.value = null;
}

/** Larger by a factor about a t that stays where it is. */
export function zoomAbout(factor: number, about?: number): void {
  const [from, to] = span.peek();
  const all = whole.peek();
  const size = all[1] - all[0];
  const least = size / MOST_ZOOM;
  const next = Math.min(size / LEAST_ZOOM, Math.max(least, (to - from) / factor));
  const fixed = about ?? (from + to) / 2;
  const share = (fixed - from) / (to - from);
  setSpan([fixed - share * next, fixed + (1 - share) * next]);
}

/** Moved by parts of what is shown. */
function panBy(share: number): void {
  const [from, to] = span.peek();
  const by = share * (to - from);
  setSpan([from + by, to + by]);
}

/** Never so far that nothing is left. */
function setSpan([from, to]: Span): void {
  const all = whole.peek();
  const size = to - from;
  const start = Math.min(all[1] - 0.1 * size, Math.max(all[0] - 0.9 * size, from));
  chosenSpan.value = [start, start + size];
}

/** The stage in CSS pixels. */
export const stageBox = signal({ width: 0, height: 0 });

/** Room for what stands beside the plot: heights on the left; below, t and the band of pieces. */
const MARGIN = { left: 54, right: 18, top: 40, bottom: 84 };
const NARROW = { left: 44, right: 12, top: 44, bottom: 80 };

/** Points of a first look, and the most of a fine one. */
const FIRST_POINTS = 800;
const MOST_POINTS = 16_384;

const plot = computed(() => {
  const { width, height } = stageBox.value;
  const margin = width < 600 ? NARROW : MARGIN;
  return {
    left: margin.left,
    top: margin.top,
    width: Math.max(1, width - margin.left - margin.right),
    height: Math.max(1, height - margin.top - margin.bottom),
  };
});

/** What of the window the graph covers; nothing where it is not drawn. */
const covered = computed<[number, number] | null>(() => {
  if (unmade.value) return null;
  const [from, to] = span.value;
  const [start, end] = interval(model.value.knots);
  const window: [number, number] = [Math.max(from, start), Math.min(to, end)];
  return window[0] < window[1] ? window : null;
});

/** t0, x0, t1, x1, .. */
export const polyline: ReadonlySignal<Float64Array> = computed(() => {
  const window = covered.value;
  if (!window) return new Float64Array(0);
  try {
    const look = rough.sampleGraph(graph.value, { window, tolerance: 0, most: FIRST_POINTS });
    const [low, high] = heights(look, window) ?? [0, 1];
    const tolerance = Math.max((high - low) / plot.value.height / 2, 1e-12 * (1 + Math.abs(high)));
    return rough.sampleGraph(graph.value, { window, tolerance, most: MOST_POINTS });
  } catch {
    return new Float64Array(0);
  }
});

/** The heights of all that is in the window. */
const tall = computed<readonly [number, number]>(() => {
  const of = [heights(polyline.value, span.value), series.value && heights(series.value.points, span.value)];
  const all = of.filter((pair) => pair !== null && pair !== undefined);
  if (all.length === 0) return [0, 1];
  return aired([Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))]);
});

/** As they were when the hand took hold: the ground must not move under what is dragged. */
const held = signal<readonly [number, number]>([0, 1]);

effect(() => {
  const now = tall.value;
  if (!inGesture.value) held.value = now;
});

export const frame: ReadonlySignal<Frame> = computed(() => ({ t: span.value, x: held.value, ...plot.value }));

/** The map that is looked at, as it copies the feature points (Fig 5, middle). */
export const copyShown: ReadonlySignal<Copy | null> = computed(() => {
  const now = search.value;
  const index = chosen.value;
  const cluster = index === null ? undefined : found.value[index];
  if (!now || !cluster || !copying.value || !current.value) return null;
  const { fine } = now.sets;
  const all: [number, number] = [fine[0] ?? 0, fine[fine.length - 2] ?? 1];
  const picked = picks.value.find((pick) => pick.cluster === index);
  const [alpha, beta] = picked?.domain ?? cluster.candidate?.domain ?? all;
  const [a, b, c, d, e] = picked?.map ?? mapOf(cluster);
  const from: number[] = [];
  const to: number[] = [];
  const near = 1e-9 * (all[1] - all[0]);
  for (let i = 0; i + 1 < fine.length; i += 2) {
    const [t, x] = [fine[i] ?? 0, fine[i + 1] ?? 0];
    if (t < alpha - near || t > beta + near) continue;
    from.push(t, x);
    to.push(a * t + d, b * t + c * x + e);
  }
  return from.length === 0 ? null : { from: Float64Array.from(from), to: Float64Array.from(to) };
});

/**
 * How far the graph is from what is measured, at the fine feature points; nothing until they are taken, and where the
 * graph is one of another stretch of t.
 */
export const errors: ReadonlySignal<{ worst: number; meanSquare: number; where: number } | null> = computed(
  () => {
    const now = sets.value;
    if (!now || now.of !== series.value || unmade.value) return null;
    const [from, to] = interval(model.value.knots);
    const [first, last] = [now.fine[0] ?? 0, now.fine[now.fine.length - 2] ?? 1];
    const near = 0.01 * (last - first);
    if (Math.abs(from - first) > near || Math.abs(to - last) > near) return null;
    return errorsOf(now.fine, value.value);
  },
);

// Mouse, finger, wheel and keys on the stage: along t.

/** How far a key moves it, in parts of what is shown. */
const KEY_PAN = 0.06;

const GRAPH: PanZoom = {
  flat: true,
  pan: (dx) => panBy(-dx / frame.peek().width),
  zoom: (factor, about) => zoomAbout(factor, about && tAt(frame.peek(), about.x)),
  fit: showAll,
};

/** Pan, pinch and wheel. Returns the end of it. `onTap`: a press that moved nothing. */
export function attachGestures(element: HTMLElement, onTap: (left: number, top: number) => void): () => void {
  return attachPanZoom(element, { ...GRAPH, tap: ({ x, y }) => onTap(x, y) });
}

/** Keys on the focused stage. True when the key was one of them. */
export const stageKey = (event: KeyboardEvent): boolean =>
  panZoomKey(event, GRAPH, KEY_PAN * frame.peek().width);

/** Whether t lies on the stage. */
export function isShown(t: number): boolean {
  const [from, to] = span.value;
  return t >= from && t <= to && Number.isFinite(leftOf(frame.value, t));
}
