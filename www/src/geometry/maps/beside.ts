/** Where a new map goes: beside those there are, and not on top of one. */
import type { MapRow } from "#wasm/api";
import { type Box, imageOf, shortBeside } from "../boxes";

/** How many places are tried each way. */
const TRIED = 24;

const overlap = (p: Box, q: Box): number =>
  Math.max(0, Math.min(p.x1, q.x1) - Math.max(p.x0, q.x0)) *
  Math.max(0, Math.min(p.y1, q.y1) - Math.max(p.y0, q.y0));

/** How far the middles of two boxes are from each other. */
const apart = (p: Box, q: Box): number =>
  Math.hypot(p.x0 + p.x1 - q.x0 - q.x1, p.y0 + p.y1 - q.y0 - q.y1) / 2;

/**
 * The same map, moved to where its image of the frame covers least of theirs; among such places to the one that is
 * farthest from the next of them. It stays inside the frame where it fits, so that the shape does not grow.
 */
export function beside(maps: readonly MapRow[], map: MapRow, frame: Box): MapRow {
  const own = imageOf(frame, map);
  const others = maps.map((other) => imageOf(frame, other));
  const size = Math.max(frame.x1 - frame.x0, frame.y1 - frame.y0);
  const [width, height] = [own.x1 - own.x0, own.y1 - own.y0];
  const spare = {
    x: Math.max(0, frame.x1 - frame.x0 - width),
    y: Math.max(0, frame.y1 - frame.y0 - height),
  };
  let best: { covered: number; far: number; x: number; y: number } | null = null;
  for (let row = 0; row <= TRIED; row++) {
    for (let column = 0; column <= TRIED; column++) {
      const x = frame.x0 + (spare.x * column) / TRIED;
      const y = frame.y0 + (spare.y * row) / TRIED;
      const there = { x0: x, y0: y, x1: x + width, y1: y + height };
      const covered = others.reduce((sum, other) => sum + overlap(there, other), 0);
      const far = others.reduce(
        (least, other) => Math.min(least, apart(there, other)),
        Number.POSITIVE_INFINITY,
      );
      // Rounding makes no place better than another.
      const less = best === null ? -1 : covered - best.covered;
      const close = Math.abs(less) <= 1e-9 * size * size;
      if (best === null || (close ? far > best.far + 1e-9 * size : less < 0)) best = { covered, far, x, y };
    }
  }
  if (best === null) return map;
  const [a, b, c, d, e, f] = map;
  const round = shortBeside(size);
  return [a, b, c, d, round(e + best.x - own.x0), round(f + best.y - own.y0)];
}

/** A copy for one more map: as small as it has to be for so many to lie side by side, a half at most. */
export function oneMore(maps: readonly MapRow[], frame: Box): MapRow {
  const scale = Math.min(0.5, 1 / (Math.floor(Math.sqrt(maps.length)) + 1));
  return beside(maps, [scale, 0, 0, scale, 0, 0], frame);
}
