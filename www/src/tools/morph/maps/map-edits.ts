import { carryFrame } from "#document/editing/frame";
import { selection } from "#document/morph";
import { notify } from "#document/notice";
import { edit, scene, undo } from "#document/scene";
import { carriedExact, exactOf, withExact } from "#geometry/maps/exact";
import { carriedWeights, withWeights } from "#geometry/maps/weighted";
import type { MapRow, Scene } from "#wasm/api";
import { type End, withShape } from "../edits";
import * as messages from "./messages";

/** Takes away the map that is chosen; none is chosen then, so that the same key takes away no other. */
export function removeChosen(): void {
  const editing = selection.peek();
  if (!editing || editing.map === null || editing.whole) return;
  const { target, map } = editing;
  const { maps } = scene.peek()[target];
  if (maps.length < 2) {
    notify({ kind: "info", text: messages.thisOnlyMapShape });
    return;
  }
  edit((before) =>
    setMaps(
      before,
      target,
      maps.filter((_, i) => i !== map),
    ),
  );
  selection.value = { target, map: null };
  notify({ kind: "info", text: messages.mapRemoved(map + 1), action: { label: messages.undo, run: undo } });
}

// What the editor of maps does to the document, as functions from scene to scene.

/** Another name for the shape of one end. It is no longer the gallery's, whose names are its own. */
export function rename(scene: Scene, end: End, name: string): Scene {
  const { preset: _, ...shape } = withExact(scene[end], exactOf(scene[end]));
  return { ...scene, [end]: { ...shape, name } };
}

/**
 * Other maps at one end. The shape keeps its name and its weights, and is no longer the gallery's. Which map becomes
 * which is told by number, so it holds only while there are as many maps as before. `exact`: formulas of entries.
 */
export function setMaps(scene: Scene, end: End, maps: MapRow[], exact: readonly string[] = []): Scene {
  const before = scene[end];
  const shape = withWeights(
    carriedExact(before, before.name, carryFrame(before.maps, maps), exact),
    carriedWeights(before, maps),
  );
  if (maps.length !== before.maps.length) return withShape(scene, end, shape);
  return { ...scene, [end]: shape };
}

/** How often the chaos game takes each map of one end; nothing: as its area says. The maps stay the very same. */
export function setWeights(scene: Scene, end: End, weights: number[] | undefined): Scene {
  return { ...scene, [end]: withWeights(scene[end], weights) };
}
