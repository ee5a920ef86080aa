/** A system of a file becomes a shape of the morph. */
import { editSystems } from "#document/curve/systems";
import { directedAtBoth, withDirected } from "#document/directed/changes";
import { selection } from "#document/morph";
import { dismiss, notify } from "#document/notice";
import { edit, lastStep, scene, undo } from "#document/scene";
import { withWeights } from "#geometry/maps/weighted";
import { choose, type End } from "#tools/morph/edits";
import type { DirectedShape, MapRow, Scene } from "#wasm/api";
import * as messages from "./messages";

/** Which end of the morph a system becomes. */
export type Where = "a" | "b" | "both";

interface Own {
  name: string;
  maps: MapRow[];
  /** How often the chaos game takes each map. */
  weights?: number[] | undefined;
  /** "#rrggbb", one a map. */
  colours?: string[] | undefined;
}

/** The document with the system at one end or both, and the moment where it is seen. */
export function withSystem(before: Scene, system: Own, where: Where): Scene {
  const ends: End[] = where === "both" ? ["a", "b"] : [where];
  const shape = withWeights({ name: system.name, maps: system.maps }, system.weights);
  const { tool: _tool, ...taken } = ends.reduce((now, end) => choose(now, end, shape), before);
  const { at: _at, ...locus } = taken.locus ?? {};
  // Colours are those of the maps of A.
  const { palette: earlier, ...rest } = taken;
  const palette = where === "b" ? earlier : system.colours;
  return {
    ...rest,
    ...(palette ? { palette } : {}),
    tool: "morph",
    t: where === "b" ? 1 : 0,
    // What was looked at off the path is not what was opened.
    ...(taken.locus ? { locus: locus as NonNullable<Scene["locus"]> } : {}),
  };
}

/** The document with a graph-directed shape at one end or both, and the moment where it is seen. */
export function withStates(before: Scene, shape: DirectedShape, where: Where): Scene {
  const end = where === "b" ? "b" : "a";
  const one = withDirected(before, end, shape);
  const { tool: _tool, view: _view, ...taken } = where === "both" ? directedAtBoth(one, end) : one;
  return { ...taken, tool: "morph", t: where === "b" ? 1 : 0 };
}

const WORDS: Record<Where, string> = {
  a: messages.nowShape,
  b: messages.nowShapeB,
  both: messages.nowBothShapes,
};

/** The notice of the last one. */
let told: number | null = null;

/** Takes it in as one step, and says so: where it became A unasked, with a way to have it as B. */
export async function intoMorph(system: Own, where: Where, said: string): Promise<void> {
  const { a: replaced } = scene.peek();
  await editSystems((before) => withSystem(before, system, where));
  selection.value = null;
  const { a: taken } = scene.peek();
  const step = lastStep();
  const instead = () => {
    // One step in all where nothing else was done; else what was done stays, and only A is as it was.
    if (lastStep() === step) undo();
    void editSystems((now) => withSystem(now.a === taken ? { ...now, a: replaced } : now, system, "b"));
  };
  tell(system.name, where, messages.mapCount(system.maps.length), said, instead);
}

/** The same of a graph-directed shape. */
export function intoStates(shape: DirectedShape, where: Where, said: string): void {
  edit((before) => withStates(before, shape, where));
  selection.value = null;
  const step = lastStep();
  const instead = () => {
    // Where something else was done since, both ends have it.
    if (lastStep() === step) undo();
    edit((now) => withStates(now, shape, "b"));
  };
  const maps = shape.states.reduce((sum, state) => sum + state.length, 0);
  tell(shape.name, where, messages.mapAndStateCount(maps, shape.states.length), said, instead);
}

function tell(name: string, where: Where, count: string, said: string, instead: () => void): void {
  // The same words again would keep the old way back.
  if (told !== null) dismiss(told);
  const text = messages.taken(name, WORDS[where], count, said).trim();
  told = notify({
    kind: "info",
    text,
    ...(where === "a" ? { action: { label: messages.openAsBInstead, run: instead } } : {}),
  });
}
