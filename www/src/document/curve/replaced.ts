/** Outlines morph with outlines alone: what had to go for that is named, with a way back. */
import type { Scene } from "#wasm/api";
import { notify } from "../notice";
import { scene, undo } from "../scene";
import { endsOf } from "../stand-in";

/** After a choice for one end: what became of the other end, if it had to give way. Whether it had to. */
export function tellReplaced(before: Scene, chosen: "a" | "b"): boolean {
  const now = scene.peek();
  if (!before.curves === !now.curves) return false;
  const end = chosen === "a" ? "b" : "a";
  const [gone, there] = [endsOf(before)[end].name, endsOf(now)[end].name];
  notify({
    kind: "info",
    text: `${gone} was put away: an outline morphs only with an outline. ${end.toUpperCase()} is ${there} for now.`,
    action: { label: "Undo", run: undo },
  });
  return true;
}
