/** What the first object can become. */

import { sameMaps } from "#geometry/maps/same-maps";
import type { Preset3, Shape3, SpaceObject } from "#wasm/api";
import * as messages from "../messages";

export interface Goal {
  id: string;
  name: string;
  /** One sentence. */
  about: string;
  shape: Shape3;
}

export const ITSELF = "itself";

/** Shapes of as many maps: of the gallery, of the other objects, and a copy to go away from. */
export function goalsOf(objects: readonly SpaceObject[], presets: readonly Preset3[]): Goal[] {
  const [first, ...others] = objects;
  if (!first) return [];
  const fits = ({ maps }: { maps: readonly unknown[] }) => maps.length === first.maps.length;
  const listed: Goal[] = presets
    .filter((preset) => fits(preset) && !sameMaps(preset.maps, first.maps))
    .map(({ id, name, about, maps }) => ({ id, name, about, shape: { preset: id, name, maps } }));
  const beside: Goal[] = [];
  others.forEach(({ preset, name, maps }, i) => {
    const known = [...listed.map(({ shape }) => shape.maps), first.maps, ...beside.map((g) => g.shape.maps)];
    if (!fits({ maps }) || known.some((other) => sameMaps(other, maps))) return;
    const shape: Shape3 = { ...(preset === undefined ? {} : { preset }), name, maps };
    beside.push({ id: `object-${i + 1}`, name, about: messages.objectThisSceneUntransformed, shape });
  });
  const itself: Goal = {
    id: ITSELF,
    name: messages.copyItself,
    about: messages.editFirstShapeAfterwards,
    shape: {
      ...(first.preset === undefined ? {} : { preset: first.preset }),
      name: first.name,
      maps: first.maps,
    },
  };
  return [...listed, ...beside, itself];
}

/** What is to be said of those that are not offered; null where the gallery has some. */
export function missingWords(count: number, presets: readonly Preset3[], name: string): string {
  const others = presets.filter(({ maps }) => maps.length !== count);
  const fits = presets.length - others.length;
  const maps = count === 1 ? "1 map" : messages.mapCount(count);
  const counts = [...new Set(others.map((preset) => preset.maps.length))].sort((a, b) => a - b);
  const rest = messages.needsSameMaps(listed(counts));
  return fits > 1 ? messages.hasMaps(name, maps, rest) : messages.noneHasAsMany(name, maps, rest);
}

function listed(counts: readonly number[]): string {
  if (counts.length < 2) return counts.join("");
  return messages.orLast(counts.slice(0, -1).join(", "), counts.at(-1) ?? 0);
}
