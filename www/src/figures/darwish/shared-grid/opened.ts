import type { GridIntersection } from "#wasm/api";
import { directedHref, preset, studioHref } from "../../kit/frame/studio-link";

const NAME = "What two shapes share";

/**
 * A link that opens what two shapes share in Morph: as a system of maps where it is one, else as a shape of several
 * states, one for each kind of pieces. Null where it is empty, points, or more than a link holds.
 */
export function openedHref({ attractor, points, system }: GridIntersection): string | null {
  try {
    if (attractor) {
      const shape = { name: NAME, maps: attractor };
      return attractor.length > 1 ? studioHref({ a: shape, b: preset("gasket") }) : null;
    }
    if (!system || points) return null;
    const shape = { name: NAME, ...system };
    return directedHref({ a: shape, b: shape, mode: "linear", t: 0 });
  } catch {
    return null;
  }
}
