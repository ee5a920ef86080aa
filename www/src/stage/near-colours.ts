/** Colours of maps of which some nearly coincide, as where two maps become one at the end of a morph. */
import type { Box } from "#geometry/boxes";
import type { MapRow } from "#wasm/api";
import { mixed } from "./curve/colours";

/** Pixels between what two maps make of the same point: nearer, they have one colour; farther, each its own. */
const ONE = 1;
const TWO = 4;

/**
 * A colour for each map. Of two maps that coincide the later one is seen. Before that, the other would be seen as thin
 * slivers along edges, wherever it alone reaches a pixel: the nearer it comes, the more it takes the later one's
 * colour. `box` holds the shape, `scale` is in pixels.
 */
export function nearColours(maps: readonly MapRow[], palette: string[], box: Box, scale: number): string[] {
  const colours = maps.map((_, i) => palette[i % palette.length] ?? "");
  let changed = false;
  for (let i = maps.length - 2; i >= 0; i--) {
    let [nearest, least] = [-1, TWO];
    for (let j = i + 1; j < maps.length; j++) {
      const far = scale * distance(maps[i] as MapRow, maps[j] as MapRow, box);
      if (far < least) [nearest, least] = [j, far];
    }
    if (nearest < 0) continue;
    const part = Math.min(1, (TWO - least) / (TWO - ONE));
    colours[i] = mixed(colours[i] ?? "", colours[nearest] ?? "", part);
    changed = true;
  }
  return changed ? colours : palette;
}

/** How far apart two maps take a point of the box, at most: it is so in a corner. */
function distance(p: MapRow, q: MapRow, { x0, y0, x1, y1 }: Box): number {
  const [a, b, c, d, e, f] = p.map((value, k) => value - (q[k] ?? 0)) as MapRow;
  let most = 0;
  for (const x of [x0, x1]) {
    for (const y of [y0, y1]) most = Math.max(most, Math.hypot(a * x + b * y + e, c * x + d * y + f));
  }
  return most;
}
