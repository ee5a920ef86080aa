/** Graph-directed shapes to choose from: those of the gallery, and outlines edge by edge. */
import type { CurvePreset, CurveShape, DirectedPreset } from "#wasm/api";
import { directed } from "#wasm/directed";
import * as messages from "./messages";

/** A shape to choose; an outline is placed beside the other end once it is chosen. */
export interface DirectedChoice extends DirectedPreset {
  outline?: CurveShape;
}

/** What the id of an outline begins with. */
const EDGES = "edges-";

/** All of them. An outline that the gallery has as a shape of its own is not there twice. */
export function directedChoices(curves: readonly CurvePreset[], fit: CurveShape | null): DirectedChoice[] {
  const presets = directed.directedPresets();
  const named = new Set(presets.map(({ id }) => id));
  const outlines = [
    ...curves
      .filter(({ id }) => !named.has(id))
      .map(({ id, name, curve }) => ({ id, shape: { preset: id, name, curve } })),
    ...(fit ? [{ id: "fit", shape: fit }] : []),
  ];
  return [...presets, ...outlines.flatMap(({ id, shape }) => edgewise(id, shape) ?? [])];
}

/** Null where it has too many edges that are copies. */
function edgewise(id: string, shape: CurveShape): DirectedChoice | null {
  try {
    const { states } = directed.outlineShape(shape.name, shape.curve, [-0.5, 0, 0.5, 1]);
    return {
      id: `${EDGES}${id}`,
      name: messages.edgeByEdge(shape.name),
      about: messages.edgeStates(shape.name),
      system: { states },
      outline: shape,
    };
  } catch {
    return null;
  }
}
