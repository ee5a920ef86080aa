/** What the stage shows: its view, and the curve as a polyline as fine as it is seen. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { inGesture } from "#document/scene";
import { type Screen, type Size, screen, type View, zoomed } from "#geometry/coordinates";
import { rough } from "#wasm/curve";
import { curve, maps } from "../model/document";

/** The stage in CSS pixels. */
export const stageBox = signal<Size>({ width: 0, height: 0 });

/** Room beside the curve. */
const MARGIN = 48;
const FOOT = 56;

/** Points of a first look, while a hand moves something, and at rest. */
const FIRST_POINTS = 1500;
const MOVING_POINTS = 12_000;
const MOST_POINTS = 131_072;
/** How far from the curve its polyline may be, in pixels. */
const FINE = 0.4;
const MOVING = 1;

/** Null shows all. */
const chosen = signal<View | null>(null);

/** A first look at all of it: t0, x0, y0, t1, .. */
export const look: ReadonlySignal<Float64Array> = computed(() => {
  const now = maps.value;
  return now
    ? rough.sampleInterpolationCurve(now, { tolerance: 0, most: FIRST_POINTS })
    : new Float64Array(0);
});

/** All of the curve and of its points, as x0, y0, x1, y1. */
const box = computed<readonly [number, number, number, number]>(() => {
  let [left, low, right, high] = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, -Infinity, -Infinity];
  const take = (x: number, y: number) => {
    if (x < left) left = x;
    if (x > right) right = x;
    if (y < low) low = y;
    if (y > high) high = y;
  };
  for (const [, x, y] of curve.value.points) take(x, y);
  const line = look.value;
  for (let i = 0; i + 2 < line.length; i += 3) take(line[i + 1] ?? 0, line[i + 2] ?? 0);
  return left <= right ? [left, low, right, high] : [0, 0, 1, 1];
});

/** As it was when the hand took hold: the ground must not move under what is dragged. */
const held = signal(box.peek());

effect(() => {
  const now = box.value;
  if (!inGesture.value) held.value = now;
});

const whole: ReadonlySignal<View> = computed(() => {
  const [left, low, right, high] = held.value;
  const { width, height } = stageBox.value;
  const across = Math.max(1, width - 2 * MARGIN) / Math.max(1e-9, right - left);
  const up = Math.max(1, height - MARGIN - FOOT) / Math.max(1e-9, high - low);
  const scale = Math.min(across, up);
  return { x: (left + right) / 2, y: (low + high) / 2 - (FOOT - MARGIN) / 2 / scale, scale };
});

export const view: ReadonlySignal<View> = computed(() => chosen.value ?? whole.value);

/** How much larger than the whole it is shown. */
export const magnified: ReadonlySignal<number> = computed(() => view.value.scale / whole.value.scale);

export function showAll(): void {
  chosen.value = null;
}

export function zoomAbout(factor: number, about?: Screen): void {
  const size = stageBox.peek();
  const point = about ?? screen(size.width / 2, size.height / 2);
  chosen.value = zoomed(view.peek(), factor, point, size, whole.peek().scale);
}

export function panBy(dx: number, dy: number): void {
  const now = view.peek();
  chosen.value = { ...now, x: now.x - dx / now.scale, y: now.y + dy / now.scale };
}

export interface Drawn {
  /** t0, x0, y0, t1, .. of what may be seen; NaN in place of what may not. */
  line: Float64Array;
  /** Whether it is as near to the curve as the stage shows. */
  complete: boolean;
}

export const drawn: ReadonlySignal<Drawn> = computed(() => {
  const now = maps.value;
  const { width, height } = stageBox.value;
  const { x, y, scale } = view.value;
  if (!now || width === 0) return { line: new Float64Array(0), complete: true };
  const moving = inGesture.value;
  const [across, up] = [width / 2 / scale, height / 2 / scale];
  const tolerance = (moving ? MOVING : FINE) / scale;
  const window: [number, number, number, number] = [x - across, y - up, x + across, y + up];
  const most = moving ? MOVING_POINTS : MOST_POINTS;
  const line = rough.sampleInterpolationCurve(now, { tolerance, window, most });
  return { line, complete: moving || widest(line) <= 1.001 * tolerance };
});

/** The longest step between two points that follow each other. */
function widest(line: Float64Array): number {
  let most = 0;
  for (let i = 3; i + 2 < line.length; i += 3) {
    const step = Math.hypot((line[i + 1] ?? 0) - (line[i - 2] ?? 0), (line[i + 2] ?? 0) - (line[i - 1] ?? 0));
    // Beside what is left out there is no step.
    if (step > most) most = step;
  }
  return most;
}
