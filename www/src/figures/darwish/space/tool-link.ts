/** What the figures on space share: links into the tool, and shapes of the gallery. */
import type { MapRow3, SpaceObject, SpaceView } from "#wasm/api";
import { frond } from "#wasm/core";
import { solid } from "#wasm/space";

/** A link that opens the tool with these objects. */
export function spaceHref(objects: SpaceObject[], view?: SpaceView): string {
  const { light } = solid.defaultSpace();
  const packed = solid.packSpace({ objects, light });
  const space = { packed, at: 0, ...(view ? { view } : {}) };
  return `#${frond.encodeScene({ ...frond.defaultScene(), tool: "space", space })}`;
}

/** The link to the tool of a figure with these objects. */
export function inSpaceTool(objects: SpaceObject[], view?: SpaceView) {
  return { href: spaceHref(objects, view), label: "Open in the Space tool" };
}

export const hasPreset = (id: string) => solid.presets3().some((one) => one.id === id);

/** The maps of a shape of the gallery. */
export function presetMaps(id: string): MapRow3[] {
  const found = solid.presets3().find((one) => one.id === id);
  if (!found) throw new Error(`The gallery of space has no shape "${id}".`);
  return found.maps;
}
