import { effect, untracked } from "@preact/signals";
import { replace, scene } from "../state/scene";
import { effectiveView, fitView, stageSize, view, zoom } from "./view";

/** Ties the view to the document, where it is kept relative to the fit: the same link fits a phone and a wall. */
let known: { x: number; y: number; zoom: number } | undefined;

export function linkView(): () => void {
  return effect(() => {
    const kept = scene.value.view;
    if (stageSize.value.width === 0 || kept === known) return;
    untracked(() => {
      known = kept;
      view.value = kept ? { x: kept.x, y: kept.y, scale: kept.zoom * fitView.peek().scale } : null;
    });
  });
}

/** Writes the view into the document, after a pan or zoom has come to rest. */
export function keepView(): void {
  const now = scene.peek();
  if (view.peek() === null) {
    known = undefined;
    if (!now.view) return;
    const { view: _, ...rest } = now;
    replace(rest);
    return;
  }
  const { x, y } = effectiveView.peek();
  known = { x, y, zoom: zoom.peek() };
  replace({ ...now, view: known });
}
