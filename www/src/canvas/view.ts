import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type Box, fitFor, stageBox } from "../state/fit";
import { reducedMotion } from "../state/preferences";
import { inGesture } from "../state/scene";

/** A point of the plane, y up. */
export interface World {
  readonly space: "world";
  readonly x: number;
  readonly y: number;
}

/** A point of the stage in CSS pixels from its upper left corner, y down. */
export interface Screen {
  readonly space: "screen";
  readonly x: number;
  readonly y: number;
}

export interface View {
  /** World point in the middle of the stage. */
  x: number;
  y: number;
  /** CSS pixels a unit. */
  scale: number;
}

export interface Size {
  width: number;
  height: number;
}

/** What part of the plane the stage shows; null fits the whole attractor. */
export const view = signal<View | null>(null);

/** The size of one picture on the stage, in CSS pixels; 0 by 0 until it is laid out. */
export const stageSize = signal<Size>({ width: 0, height: 0 });

export const MARGIN = 0.09;
const MOST_ZOOM = 1e12;
const LEAST_ZOOM = 1 / 64;

/** The box that the fit shows: it follows the document, but not while something is dragged, and without a jump. */
const fitted = signal<Box | null>(null);

export const fitView: ReadonlySignal<View> = computed(() =>
  fitFor(fitted.value ?? stageBox.value, sizeOr(stageSize.value), MARGIN),
);

/** The view that is drawn. */
export const effectiveView: ReadonlySignal<View> = computed(() => view.value ?? fitView.value);

/** How much larger than the fit the picture is shown: 1 is the fit. */
export const zoom: ReadonlySignal<number> = computed(() => effectiveView.value.scale / fitView.value.scale);

function sizeOr(size: Size): Size {
  return size.width > 0 && size.height > 0 ? size : { width: 1, height: 1 };
}

export function world(x: number, y: number): World {
  return { space: "world", x, y };
}

export function screen(x: number, y: number): Screen {
  return { space: "screen", x, y };
}

export function toScreen(p: World, v: View, size: Size): Screen {
  return screen(size.width / 2 + (p.x - v.x) * v.scale, size.height / 2 - (p.y - v.y) * v.scale);
}

export function toWorld(p: Screen, v: View, size: Size): World {
  return world(v.x + (p.x - size.width / 2) / v.scale, v.y - (p.y - size.height / 2) / v.scale);
}

/** The view moved so that the world follows the pointer by (dx, dy) CSS pixels. */
export function panned(v: View, dx: number, dy: number): View {
  return { ...v, x: v.x - dx / v.scale, y: v.y + dy / v.scale };
}

/** The view enlarged by a factor about a point of the stage, which stays where it is. */
export function zoomed(v: View, factor: number, about: Screen, size: Size, fitScale: number): View {
  const scale = Math.min(fitScale * MOST_ZOOM, Math.max(fitScale * LEAST_ZOOM, v.scale * factor));
  const fixed = toWorld(about, v, size);
  return {
    x: fixed.x - (about.x - size.width / 2) / scale,
    y: fixed.y + (about.y - size.height / 2) / scale,
    scale,
  };
}

const EASE_MS = 220;

/** Keeps the fitted box on its way to where it should be. Returns the end of it. */
export function followFit(start: (tick: (now: number) => boolean) => () => void): () => void {
  let stop = () => {};
  const unsubscribe = computed(() => ({ box: stageBox.value, held: inGesture.value })).subscribe(
    ({ box, held }) => {
      if (held && fitted.peek()) return;
      const from = fitted.peek();
      stop();
      if (!from || reducedMotion.peek() || view.peek()) {
        fitted.value = box;
        return;
      }
      if (near(from, box)) return;
      let began: number | null = null;
      stop = start((now) => {
        began ??= now;
        const s = Math.min(1, (now - began) / EASE_MS);
        fitted.value = blend(from, box, s * s * (3 - 2 * s));
        return s < 1;
      });
    },
  );
  return () => {
    stop();
    unsubscribe();
  };
}

function near(p: Box, q: Box): boolean {
  const least = 1e-6 * Math.max(q.x1 - q.x0, q.y1 - q.y0);
  return Math.max(...KEYS.map((key) => Math.abs(p[key] - q[key]))) <= least;
}

function blend(p: Box, q: Box, s: number): Box {
  const at = (key: keyof Box) => p[key] + s * (q[key] - p[key]);
  return { x0: at("x0"), y0: at("y0"), x1: at("x1"), y1: at("y1") };
}

const KEYS = ["x0", "y0", "x1", "y1"] as const;
