import type { Box } from "#geometry/boxes";
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";

/** The box of an attractor, or null where there is none. */
export function boxOf(maps: MapRow[]): Box | null {
  try {
    const { min, max } = frond.bounds({ maps });
    const box = { x0: min[0], y0: min[1], x1: max[0], y1: max[1] };
    return Object.values(box).every(Number.isFinite) ? box : null;
  } catch {
    return null;
  }
}
