/**
 * The frame of a shape that is edited: the box whose images its maps are shown as. It stands still while maps are
 * moved, so that a parallelogram that nobody touches stays where it is, or follows the shape where that is chosen.
 */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { type Box, imageOf, shortBeside, UNIT, union } from "#geometry/boxes";
import type { MapRow } from "#wasm/api";
import { boxOf } from "../bounds";
import { selection } from "../morph";
import { inGesture, scene } from "../scene";

export interface EditFrame {
  box: Box;
  /** What the stage shows when it fits: the frame, its images and the shape, as they were when it was last asked. */
  seen: Box;
  /** The box is that of the shape, whatever becomes of it, and so is the view. */
  follows: boolean;
}

/** How narrow a frame may be, in proportion: of a shape on a line nothing could be taken hold of. */
const NARROWEST = 0.25;

/** Of each list of maps that was edited: all lists of one shape share it, so that undo leaves it as it is. */
const known = new WeakMap<readonly MapRow[], { frame: EditFrame }>();
/** How often a frame was changed. */
const changed = signal(0);

/** A frame around a shape, which has an area although the shape may be a point. */
export function frameAround(maps: MapRow[]): Box {
  const box = boxOf(maps) ?? UNIT;
  const { x0, y0, x1, y1 } = box;
  const longest = Math.max(x1 - x0, y1 - y0);
  // What is left of a point by rounding is no size.
  const size = longest > 1e-9 * Math.max(1, ...[x0, y0, x1, y1].map(Math.abs)) ? longest : 1;
  const widen = (low: number, high: number): [number, number] => {
    const lacks = NARROWEST * size - (high - low);
    return lacks > 0 ? [low - lacks / 2, high + lacks / 2] : [low, high];
  };
  const round = shortBeside(size);
  const [left, right] = widen(x0, x1).map(round) as [number, number];
  const [low, high] = widen(y0, y1).map(round) as [number, number];
  return { x0: left, y0: low, x1: right, y1: high };
}

/** The shape with its frame and the images of that, so that no handle is out of reach. */
function seenAround(maps: MapRow[], frame: Box): Box {
  return union([frame, boxOf(maps) ?? frame, ...maps.map((map) => imageOf(frame, map))]);
}

/** Whether maps were made in the unit square: each takes it into itself. Then it is the frame to go on with. */
function inUnitSquare(maps: readonly MapRow[]): boolean {
  return maps.every((map) => {
    const { x0, y0, x1, y1 } = imageOf(UNIT, map);
    return Math.min(x0, y0) >= -1e-9 && Math.max(x1, y1) <= 1 + 1e-9;
  });
}

/** The frame of a shape: as it was left, else around the shape as it is now. */
export function frameOf(maps: MapRow[], ofGallery = false): EditFrame {
  let shared = known.get(maps);
  if (!shared) {
    const box = !ofGallery && inUnitSquare(maps) ? UNIT : frameAround(maps);
    shared = { frame: { box, seen: seenAround(maps, box), follows: false } };
    known.set(maps, shared);
  }
  return shared.frame;
}

/** Other maps of the same shape keep its frame. */
export function carryFrame(before: readonly MapRow[], after: MapRow[]): MapRow[] {
  const shared = known.get(before);
  if (shared) known.set(after, shared);
  return after;
}

/** Another frame for the maps, which the stage is fitted to; by a hand on the stage, under which that stays. */
export function setFrame(maps: MapRow[], box: Box, { follows = false, byHand = false } = {}): void {
  const shared = known.get(maps);
  const seen = (byHand && shared?.frame.seen) || seenAround(maps, box);
  const frame = { box, seen, follows };
  if (shared) shared.frame = frame;
  else known.set(maps, { frame });
  changed.value++;
}

/** The last one that stood still: what follows does so when the hand lets go. */
let resting: EditFrame | null = null;

/** The frame of the shape that is edited map by map; null where none is. */
export const editFrame: ReadonlySignal<EditFrame | null> = computed(() => {
  changed.value;
  const editing = selection.value;
  if (!editing || editing.whole) {
    resting = null;
    return null;
  }
  const { maps, preset } = scene.value[editing.target];
  const frame = frameOf(maps, preset !== undefined);
  if (!frame.follows) return frame;
  if (!inGesture.value || resting === null) {
    const box = frameAround(maps);
    resting = { box, seen: seenAround(maps, box), follows: true };
  }
  return resting;
});

/** The view is to be fitted to what there is now. */
export function refitEdited(): void {
  const editing = selection.peek();
  const frame = editFrame.peek();
  if (!(editing && frame) || frame.follows) return;
  setFrame(scene.peek()[editing.target].maps, frame.box);
}

/** All that is edited, as it is now: the shape, the frame and its images; null where nothing is. */
export const editedNow: ReadonlySignal<Box | null> = computed(() => {
  const frame = editFrame.value;
  const editing = selection.value;
  return frame && editing ? seenAround(scene.value[editing.target].maps, frame.box) : null;
});
