/** A shadow that is a system of the plane goes on into the tools of the plane. */

import { editSystems } from "#document/curve/systems";
import { boxAround } from "#document/deform/bend";
import { selection } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { openTool } from "#document/tool";
import { inBox } from "#geometry/mesh";
import type { MapRow, Scene, Shape, Tool } from "#wasm/api";
import * as messages from "../messages";

/** Without the dust of a turn: what is nothing is 0, and a half is a half. */
export function tidy(maps: readonly MapRow[]): MapRow[] {
  return maps.map((map) => map.map((x) => (Math.abs(x) < 1e-12 ? 0 : Number(x.toPrecision(12)))) as MapRow);
}

/** Each map once: what lay behind each other in space is the same in the shadow. */
export function different(maps: readonly MapRow[]): MapRow[] {
  const all = new Map(maps.map((map) => [map.map((x) => x.toFixed(9)).join(), map]));
  return [...all.values()];
}

/** The shape as A, seen as a whole at the start of the morph. What the grid bends it is around. */
export function withA(scene: Scene, shape: Shape, box: Parameters<typeof inBox>[1]): Scene {
  const { locus: _locus, view: _view, ...rest } = scene;
  const deform = rest.deform ? { deform: inBox({ ...rest.deform, subject: "shape" }, box) } : {};
  return { ...rest, ...deform, a: shape, t: 0, correspondence: [], turns: [] };
}

/** Takes a system of the plane into another tool: one undo step, then the tool. */
export async function takeShadow(name: string, maps: readonly MapRow[], tool: Tool): Promise<void> {
  const shape: Shape = { name: messages.shadowOf(name).slice(0, 60), maps: different(tidy(maps)) };
  try {
    const box = boxAround(shape.maps);
    await editSystems((scene) => withA(scene, shape, box));
    selection.value = null;
    openTool(tool);
    notify({ kind: "info", text: messages.isShapeA(shape.name) });
  } catch (problem) {
    notify({ kind: "error", text: messages.shadowNotUsed(wordsOf(problem)) });
  }
}
