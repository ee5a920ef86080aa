import { selection } from "#document/morph";
import { announce, notify } from "#document/notice";
import { edit, scene } from "#document/scene";
import { setMaps } from "./changes";

/** Takes away the map that is chosen; the one before it is chosen then. */
export function removeChosen(): void {
  const editing = selection.peek();
  if (!editing || editing.map === null || editing.whole) return;
  const { target, map } = editing;
  const { maps } = scene.peek()[target];
  if (maps.length < 2) {
    notify({ kind: "info", text: "This is the only map, and a shape has at least one." });
    return;
  }
  edit((before) =>
    setMaps(
      before,
      target,
      maps.filter((_, i) => i !== map),
    ),
  );
  selection.value = { target, map: Math.max(0, map - 1) };
  announce(`Map ${map + 1} is removed.`);
}
