/** Bends along a time line: where the control points are is that of a moment, all else is so for all time. */
import { keyNow, withItem } from "#document/space/edits";
import { editSpace, space, spaceFrame, timeline } from "#document/space/space";
import type { Point3, Space, SpaceBend, SpaceTimeline } from "#wasm/api";
import { withBend, withSizes } from "./changes";

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
export function withoutBend(before: Space, index: number): Space {
  return withKeyed(withBend(before, index, null), index, () => null);
}

/** Another number of control points, in all keys: each where the lattice before has that place. */
export function withLattice(before: Space, index: number, to: SpaceBend): Space {
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
