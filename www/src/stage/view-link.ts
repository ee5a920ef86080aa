/** The view of the stage, kept in the document. */
import { effect, untracked } from "@preact/signals";
import { selection } from "#document/morph";
import { replace, scene } from "#document/scene";
import type { View } from "#geometry/coordinates";
import { baseView, effectiveView, stageSize, view } from "./view";

/** Ties the view to the document, where it is kept relative to the fit: the same link fits a phone and a wall. */
let known: { x: number; y: number; zoom: number } | undefined;

export function linkView(): () => void {
  // Editing a shape has a view of its own, which ends with it.
  let saved: View | null = null;
  let wasEditing = false;
  const stopEditing = effect(() => {
    const editing = selection.value !== null;
    untracked(() => {
      if (editing && !wasEditing) saved = view.peek();
      if (editing !== wasEditing) view.value = editing ? null : saved;
    });
    wasEditing = editing;
  });
  const stopRead = effect(() => {
    const kept = scene.value.view;
    if (selection.value || stageSize.value.width === 0 || kept === known) return;
    untracked(() => {
      known = kept;
      view.value = kept ? { x: kept.x, y: kept.y, scale: kept.zoom * baseView.peek().scale } : null;
    });
  });
  // Whoever asks for the fit asks the document to forget its view.
  const stopFit = effect(() => {
    if (view.value === null && stageSize.peek().width > 0) untracked(keepView);
  });
  return () => {
    stopEditing();
    stopRead();
    stopFit();
  };
}

/** Writes the view into the document, after a pan or zoom has come to rest. */
export function keepView(): void {
  if (selection.peek()) return;
  const now = scene.peek();
  if (view.peek() === null) {
    known = undefined;
    if (!now.view) return;
    const { view: _, ...rest } = now;
    replace(rest);
    return;
  }
  const { x, y, scale } = effectiveView.peek();
  known = { x, y, zoom: scale / baseView.peek().scale };
  replace({ ...now, view: known });
}
