/** Outlines morph with outlines alone: what had to go for that is named, with ways back. */
import type { CurveShape, Scene } from "#wasm/api";
import { oneState } from "../directed/changes";
import * as messages from "../messages";
import { notify } from "../notice";
import { scene, undo } from "../scene";
import { endsOf } from "../stand-in";

/** As much of a name as a button has room for. */
const MOST_LETTERS = 18;
const short = (name: string) =>
  name.length > MOST_LETTERS ? `${name.slice(0, MOST_LETTERS - 1).trimEnd()}…` : name;

/**
 * After a choice for one end: what became of the other end, if it had to give way; of what is bent, what was there
 * before. Whether it had to. A shape that gave way to an outline is offered edge by edge with the outline.
 */
export function tellReplaced(before: Scene, chosen: "a" | "b" | "bent"): boolean {
  const now = scene.peek();
  if (!before.curves === !now.curves) return false;
  const end = chosen === "a" ? "b" : "a";
  const [gone, there] = [endsOf(before)[end].name, endsOf(now)[end].name];
  const action = { label: messages.undo, run: undo };
  if (chosen === "bent") {
    notify({ kind: "info", text: messages.replaced(gone, there), action });
    return true;
  }
  const outline = now.curves?.[chosen];
  notify({
    kind: "info",
    text: messages.outlinesMorphIntoOutlines(end.toUpperCase(), there, gone),
    action,
    ...(outline ? { instead: edgeByEdge(before, chosen, outline) } : {}),
  });
  return true;
}

/** The morph of what was there and the outline, from where that is. */
function edgeByEdge(before: Scene, chosen: "a" | "b", outline: CurveShape) {
  const kept =
    chosen === "b" ? (before.directed?.a ?? oneState(before.a)) : (before.directed?.b ?? oneState(before.b));
  const [gone, there] = [short(kept.name), short(outline.name)];
  return {
    label: chosen === "b" ? messages.aToB(gone, there) : messages.aToB(there, gone),
    run: async () => {
      const { withOutline } = await import("../directed/outlines");
      await withOutline(chosen, outline, kept);
    },
  };
}
