/** The bend of the chosen object, the box it lies over, and where its handles are on the stage. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { announce, notify, wordsOf } from "#document/notice";
import { keyNow, withItem } from "#document/space/edits";
import {
  chosen,
  editSpace,
  keepView,
  space,
  spaceFrame,
  spacePlaying,
  spaceView,
  timeline,
} from "#document/space/space";
import { apply3, turned } from "#geometry/maps/affine3";
import type { BendRoom3, MapRow3, Point3, Space, SpaceBend, SpaceTimeline } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { made, moved } from "../shape/now";
import { type Pixel, projected, shiftByHand } from "../stage/camera";
import { stageSize } from "../stage/state";
import { nameOf, placeOf, tidy, withBend, withMoved, withSizes } from "./bend-edits";

// Bends along a time line: where the control points are is that of a moment, all else is so for all time.

/** The bend of an object as it is at the moment. */
export function bentNow(index: number): SpaceBend | null {
  const made = space.value?.objects[index]?.bend;
  if (!made) return null;
  const moves = spaceFrame.value?.objects[index]?.bend;
  return moves && moves.length === made.moves.length ? { ...made, moves } : made;
}

const hasKeys = (line: SpaceTimeline, index: number) => line.keys.some((key) => key.bends?.[index]);

const same = (a: readonly Point3[], b: readonly Point3[]) =>
  a.length === b.length && a.every((by, i) => by.every((x, axis) => x === b[i]?.[axis]));

/**
 * Another bend of an object; null: none. With a time line, control points that went elsewhere are a key of its moment,
 * and the other keys keep what was. Throws where a link cannot hold it.
 */
export function bendObject(index: number, to: SpaceBend | null, options: { gesture?: string } = {}): void {
  const line = timeline.peek();
  const made = space.peek()?.objects[index]?.bend;
  const now = bentNow(index);
  if (!to || !line || !made || !now) {
    editSpace((before) => (to ? withBend(before, index, to) : withoutBend(before, index)), options);
    return;
  }
  if (to.moves.length !== made.moves.length || to.sizes.some((size, axis) => size !== made.sizes[axis])) {
    editSpace((before) => withLattice(before, index, to), options);
  } else if (same(to.moves, now.moves)) {
    editSpace((before) => withBend(before, index, { ...to, moves: made.moves }), options);
  } else {
    const first = !hasKeys(line, index);
    keyNow(
      (key, count) => ({ ...key, bends: withItem(key.bends, count, index, to.moves) }),
      options,
      (key, count) => (first ? { ...key, bends: withItem(key.bends, count, index, now.moves) } : key),
    );
  }
}

/** Neither the object nor the time line says of a bend. */
function withoutBend(before: Space, index: number): Space {
  return withKeyed(withBend(before, index, null), index, () => null);
}

/** Another number of control points, in all keys: each where the lattice before has that place. */
function withLattice(before: Space, index: number, to: SpaceBend): Space {
  const made = before.objects[index]?.bend;
  if (!made) return withBend(before, index, to);
  const kept = { ...to, moves: withSizes(made, to.sizes).moves };
  return withKeyed(withBend(before, index, kept), index, (moves) =>
    moves.length === made.moves.length ? withSizes({ ...made, moves }, to.sizes).moves : null,
  );
}

function withKeyed(now: Space, index: number, change: (moves: Point3[]) => Point3[] | null): Space {
  if (!now.timeline) return now;
  const keys = now.timeline.keys.map((key) => {
    const moves = key.bends?.[index];
    if (!moves) return key;
    const { bends, ...rest } = key;
    const list = (bends ?? []).map((old, i) => (i === index ? change(moves) : old));
    return list.some((one) => one !== null) ? { ...rest, bends: list } : rest;
  });
  return { ...now, timeline: { ...now.timeline, keys } };
}

/** As it is at the moment of the time line. */
export const bend: ReadonlySignal<SpaceBend | null> = computed(() => bentNow(chosen.value));

let known: { key: string; room: BendRoom3 | null } | null = null;

/** null where the shape has no attractor. */
export const room: ReadonlySignal<BendRoom3 | null> = computed(() => {
  const maps = made.value;
  if (maps.length === 0) return null;
  const key = JSON.stringify(maps);
  if (known?.key !== key) known = { key, room: roomOf(maps) };
  return known.room;
});

function roomOf(maps: MapRow3[]): BendRoom3 | null {
  try {
    return solid.bendRoom3(maps);
  } catch {
    return null;
  }
}

/** The sides of the box, in units of space. */
export function sidesOf({ min, max }: Pick<BendRoom3, "min" | "max">): Point3 {
  return [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
}

export const sizeOf = (room: Pick<BendRoom3, "min" | "max">): number => Math.max(...sidesOf(room));

/** Where the control points are, as the object lies. */
const points: ReadonlySignal<Point3[]> = computed(() => {
  const [now, box] = [bend.value, room.value];
  if (!now || !box) return [];
  const [sides, size] = [sidesOf(box), sizeOf(box)];
  return now.moves.map((by, i) => {
    const place = placeOf(now.sizes, i);
    const at = [0, 1, 2].map(
      (k) => (box.min[k] ?? 0) + (sides[k] ?? 0) * (place[k] ?? 0) + size * (by[k] ?? 0),
    );
    return apply3(moved.value, at as Point3);
  });
});

/** The same on the stage; null for what is behind the eye. */
export const handles: ReadonlySignal<(Pixel | null)[]> = computed(() => {
  const view = spaceView.value;
  const size = stageSize.value;
  return view ? points.value.map((point) => projected(view, point, size)) : [];
});

const held = signal(0);

/** The handle that keys and numbers are about. */
export const lead: ReadonlySignal<number> = computed(() =>
  Math.min(held.value, Math.max(0, (bend.value?.moves.length ?? 1) - 1)),
);

export function take(index: number): void {
  held.value = index;
}

/** One step to undo, or a part of one. */
export function changeBend(change: (bend: SpaceBend) => SpaceBend | null, gesture?: string): boolean {
  const now = bend.peek();
  if (!now) return false;
  const after = change(now);
  if (after === now) return true;
  // Else the view would follow.
  keepView();
  spacePlaying.value = false;
  const options = gesture === undefined ? {} : { gesture };
  try {
    bendObject(chosen.peek(), after, options);
    return true;
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
    return false;
  }
}

/** A handle along a direction of space, in units of it. */
function shift(index: number, by: Point3, gesture: string): void {
  const box = room.peek();
  if (!box) return;
  try {
    const own = turned(solid.invert3(moved.peek()), by);
    const size = sizeOf(box);
    const parts = own.map((x) => tidy(x / size)) as Point3;
    changeBend((now) => withMoved(now, index, parts), gesture);
  } catch {
    // What was flattened has no way back: numbers move its handles all the same.
  }
}

/** By so many pixels of a hand, in the plane of the picture. */
export function pull(index: number, dx: number, dy: number, gesture: string): void {
  const [view, at] = [spaceView.peek(), handles.peek()[index]];
  if (!view || !at) return;
  shift(index, shiftByHand(view, dx, dy, at.depth, stageSize.peek().height), gesture);
}

/** Nearer to the eye or farther from it, by a part of the box. */
export function push(index: number, part: number, gesture: string): void {
  const [view, box] = [spaceView.peek(), room.peek()];
  if (!view || !box) return;
  const stretch = Math.cbrt(Math.abs(solid.place3(moved.peek()).determinant)) || 1;
  const far = part * sizeOf(box) * stretch;
  const [s, c] = [Math.sin(view.turn), Math.cos(view.turn)];
  const flat = Math.cos(view.tilt);
  shift(index, [-s * flat * far, c * flat * far, -Math.sin(view.tilt) * far], gesture);
}

/** A handle's name, and how far it is moved. */
export function handleWords(index: number): string {
  const now = bend.value;
  const by = now?.moves[index];
  if (!now || !by) return messages.handle2;
  const parts = by.map((x) => `${Math.round(1000 * x) / 10}`.replace("-", "−"));
  return messages.handleMovedBy(nameOf(now.sizes, index), parts.join(", "));
}

export function tell(index: number): void {
  announce(handleWords(index));
}
