/**
 * A shape of the morph taken in hand as a whole: what is done to it is one transform, and its maps are conjugated by
 * it (Darwish & Abd-El-Wahab, eq 1). The document keeps the maps; how the shape was when it was taken is remembered
 * beside them, so that no rounding adds up, and what is undone is as it was.
 */
import { carriedExact } from "#geometry/maps/exact";
import { withWeights } from "#geometry/maps/weighted";
import type { MapRow, Shape } from "#wasm/api";
import { frond } from "#wasm/core";
import { edit, scene } from "../scene";

/** The shape as it was taken in hand, and all that was done to it since. */
export interface Taken {
  made: Shape;
  moved: MapRow;
}

export const STILL: MapRow = [1, 0, 0, 1, 0, 0];

/** Of each list of maps that a hand has made: undo and redo come back to the same lists. */
const known = new WeakMap<readonly MapRow[], Taken>();

export function takenOf(shape: Shape): Taken {
  return known.get(shape.maps) ?? { made: shape, moved: STILL };
}

/**
 * Puts the shape of one end there, all in one transform; null: where it was taken. Throws where that has no inverse, or
 * its maps would be no shape: nothing changes.
 */
export function placeShape(end: "a" | "b", moved: MapRow | null, options: { gesture?: string } = {}): void {
  const { made } = takenOf(scene.peek()[end]);
  const still = moved === null || moved.every((x, i) => x === STILL[i]);
  const shape = still ? made : conjugated(made, moved);
  edit((before) => {
    const { maps, weights } = before[end];
    return maps === shape.maps ? before : { ...before, [end]: withWeights(shape, weights) };
  }, options);
}

function conjugated(made: Shape, moved: MapRow): Shape {
  const { maps } = frond.conjugate({ maps: made.maps }, moved);
  frond.validate({ maps });
  // Moved maps are no preset any more.
  known.set(maps, { made, moved });
  return carriedExact(made, made.name, maps);
}
