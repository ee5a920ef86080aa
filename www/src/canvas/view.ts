import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type Box, fitFor, stageBox } from "../state/fit";
import { reducedMotion } from "../state/preferences";
import { inGesture } from "../state/scene";
import type { Size, View } from "./geometry";

/** What part of the plane the stage shows; null fits the whole attractor. */
export const view = signal<View | null>(null);

/** The size of one picture on the stage, in CSS pixels; 0 by 0 until it is laid out. */
export const stageSize = signal<Size>({ width: 0, height: 0 });

/** Free on each side as a part of the shorter one, and below as many pixels more: the verdict stands there. */
const MARGIN = 0.06;
const FOOT = 44;
/** The box that the fit shows: it follows the document, but not while something is dragged, and without a jump. */
const fitted = signal<Box | null>(null);

export const fitView: ReadonlySignal<View> = computed(() => {
  const size = sizeOr(stageSize.value);
  const edge = MARGIN * Math.min(size.width, size.height);
  const insets = { top: edge, right: edge, bottom: edge + FOOT, left: edge };
  return fitFor(fitted.value ?? stageBox.value, size, insets);
});

/** The view that is drawn. */
export const effectiveView: ReadonlySignal<View> = computed(() => view.value ?? fitView.value);

/** How much larger than the fit the picture is shown: 1 is the fit. */
export const zoom: ReadonlySignal<number> = computed(() => effectiveView.value.scale / fitView.value.scale);

function sizeOr(size: Size): Size {
  return size.width > 0 && size.height > 0 ? size : { width: 1, height: 1 };
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
