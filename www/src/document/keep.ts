/** What undo leaves to whoever looks. */
import type { Scene } from "#wasm/api";
import type { Keep } from "./history";

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

const parts: Keep[] = [keepPlace];

/** A tool has something in its part of the document that is to be left, too. */
export function keepToo(part: Keep): void {
  parts.push(part);
}

export const keep: Keep = (target, other, present) =>
  parts.reduce((scene, part) => part(scene, other, present), target);
