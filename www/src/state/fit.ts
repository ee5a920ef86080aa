import { computed, type ReadonlySignal } from "@preact/signals";
import type { MapRow } from "../engine/api";
import { frond } from "../engine/wasm";
import { mapsAt, morphOptions, pathPoints, selection, shown } from "./morph";
import { uvAt } from "./path";

/** A rectangle of the plane. */
export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** How often the path is looked at, and how much larger than its ends a morph may grow before it leaves the stage. */
const LOOKS = 13;
const GROWTH = 3;
const UNIT: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };

/** The box of an attractor, or null where there is none. */
export function boxOf(maps: MapRow[]): Box | null {
  try {
    const { min, max } = frond.bounds({ maps });
    const box = { x0: min[0], y0: min[1], x1: max[0], y1: max[1] };
    return Object.values(box).every(Number.isFinite) ? box : null;
  } catch {
    return null;
  }
}

/**
 * One box for the whole path, so that the picture keeps still while it is scrubbed. Moments at which the morph grows
 * beyond measure do not count: they would make all others specks.
 */
export const pathBox: ReadonlySignal<Box> = computed(() => {
  const points = pathPoints.value;
  const options = morphOptions.value;
  const boxes = Array.from({ length: LOOKS }, (_, i) =>
    boxOf(mapsAt(uvAt(points, i / (LOOKS - 1)), options)),
  );
  const ends = [boxes[0], boxes[LOOKS - 1]].filter((box) => box != null);
  const most = GROWTH * Math.max(...ends.map(diagonal));
  const counted = boxes.filter((box) => box !== null).filter((box) => !(diagonal(box) > most));
  return union(counted) ?? UNIT;
});

/** What the stage fits: the whole path, or the shape that is being edited. */
export const stageBox: ReadonlySignal<Box> = computed(() =>
  selection.value ? editBox(shown.value) : pathBox.value,
);

/** A shape with the parallelograms of its maps, so that no handle is out of reach. */
function editBox(maps: MapRow[]): Box {
  const box = boxOf(maps);
  if (!box) return pathBox.value;
  const images = maps.map(([a, b, c, d, e, f]): Box => {
    const xs = [box.x0, box.x1].flatMap((x) => [box.y0, box.y1].map((y) => a * x + b * y + e));
    const ys = [box.x0, box.x1].flatMap((x) => [box.y0, box.y1].map((y) => c * x + d * y + f));
    return { x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys) };
  });
  return union([box, ...images]) ?? box;
}

export function diagonal(box: Box): number {
  return Math.hypot(box.x1 - box.x0, box.y1 - box.y0);
}

function union(boxes: Box[]): Box | null {
  if (boxes.length === 0) return null;
  return {
    x0: Math.min(...boxes.map((b) => b.x0)),
    y0: Math.min(...boxes.map((b) => b.y0)),
    x1: Math.max(...boxes.map((b) => b.x1)),
    y1: Math.max(...boxes.map((b) => b.y1)),
  };
}

/** What stays free round a fitted box, in pixels of the picture. */
export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** The view that shows a box in the middle of what the insets leave of a picture. A number is a part of each side. */
export function fitFor(
  box: Box,
  size: { width: number; height: number },
  insets: Insets | number,
): { x: number; y: number; scale: number } {
  // A shape that is a point still gets a picture, and a picture that is all insets a scale.
  const across = Math.max(box.x1 - box.x0, 1e-9);
  const up = Math.max(box.y1 - box.y0, 1e-9);
  const { top, right, bottom, left } = typeof insets === "number" ? even(insets, size) : insets;
  const width = Math.max(size.width - left - right, 0.1 * size.width);
  const height = Math.max(size.height - top - bottom, 0.1 * size.height);
  const scale = Math.max(Math.min(width / across, height / up), 1e-6);
  return {
    x: (box.x0 + box.x1) / 2 + (right - left) / 2 / scale,
    y: (box.y0 + box.y1) / 2 + (top - bottom) / 2 / scale,
    scale,
  };
}

function even(part: number, { width, height }: { width: number; height: number }): Insets {
  return { top: part * height, right: part * width, bottom: part * height, left: part * width };
}
