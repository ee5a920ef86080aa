/** Which part of t the stage shows. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { model } from "./document";
import { interval } from "./model";
import { series, unmade } from "./series";

export type Span = readonly [from: number, to: number];

/** How much is free beside the whole, in its parts. */
const MARGIN = 0.04;
const MOST_ZOOM = 1e9;
const LEAST_ZOOM = 1 / 4;

/** Null shows all. */
const chosen = signal<Span | null>(null);

/** All of the graph and of what is measured. */
export const whole: ReadonlySignal<Span> = computed(() => {
  const points = series.value?.points;
  const drawn = unmade.value ? null : interval(model.value.knots);
  const measured = points ? [points[0] ?? 0, points[points.length - 2] ?? 1] : null;
  const ends = [drawn, measured].flatMap((pair) => pair ?? []);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const edge = MARGIN * (high - low);
  return [low - edge, high + edge];
});

export const span: ReadonlySignal<Span> = computed(() => chosen.value ?? whole.value);

/** How much larger than the whole it is shown. */
export const magnified: ReadonlySignal<number> = computed(() => {
  const [all, now] = [whole.value, span.value];
  return (all[1] - all[0]) / (now[1] - now[0]);
});

export function showAll(): void {
  chosen.value = null;
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
  set([fixed - share * next, fixed + (1 - share) * next]);
}

/** Moved by parts of what is shown. */
export function panBy(share: number): void {
  const [from, to] = span.peek();
  const by = share * (to - from);
  set([from + by, to + by]);
}

/** Never so far that nothing is left. */
function set([from, to]: Span): void {
  const all = whole.peek();
  const size = to - from;
  const start = Math.min(all[1] - 0.1 * size, Math.max(all[0] - 0.9 * size, from));
  chosen.value = [start, start + size];
}
