/** What the stage shows: its frame, and the graph as a polyline as fine as it is seen. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { inGesture } from "#document/scene";
import { rough } from "#wasm/curve";
import { graph, model } from "../model/document";
import { interval } from "../model/model";
import { series, unmade } from "../model/series";
import { span } from "../model/span";
import { aired, type Frame, heights } from "./frame";

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
