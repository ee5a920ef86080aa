/** What undo leaves to whoever looks. */
import type { Scene } from "#wasm/api";
import { keepPhase } from "./deform/keep";
import type { Keep } from "./history";
import { keepLook } from "./space/keep";

/** The moment of the morph, the view and the tool. */
const keepPlace: Keep = (target, other, present) => {
  const scene: Scene = { ...target, t: target.t === other.t ? present.t : target.t };
  const view = target.view === other.view ? present.view : target.view;
  if (view) scene.view = view;
  else delete scene.view;
  const tool = target.tool === other.tool ? present.tool : target.tool;
  if (tool) scene.tool = tool;
  else delete scene.tool;
  return scene;
};

const KEEP: readonly Keep[] = [keepPlace, keepPhase, keepLook];

export const keep: Keep = (target, other, present) =>
  KEEP.reduce((scene, part) => part(scene, other, present), target);
