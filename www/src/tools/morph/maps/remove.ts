import { selection } from "#document/morph";
import { notify } from "#document/notice";
import { edit, scene, undo } from "#document/scene";
import { setMaps } from "./changes";
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
