/** Where a dragged map comes to rest: at corners, middles, edges and angles of the others that it nearly reaches. */
import type { MapRow } from "#wasm/api";
import type { Box } from "./boxes";
import { type World, world } from "./coordinates";
import {
  angleOf,
  armOf,
  type Corners,
  cornersOf,
  dragged,
  type Grip,
  middleOf,
  turned,
} from "./parallelogram";

/** What there is to rest at: of the frame itself and of every other map. */
export interface Rests {
  points: World[];
  edges: [World, World][];
}

/** A side comes to rest at every so many degrees, and a map that is turned when it is so near to them. */
const ANGLE = 15;
const NEAR_ANGLE = 3;
const DEGREE = Math.PI / 180;

const sides = ({ origin, x, y, turn }: Corners): [World, World][] => [
  [origin, x],
  [x, turn],
  [turn, y],
  [y, origin],
];

/** Everything that map `index` may rest at. */
export function restsOf(maps: readonly MapRow[], index: number, frame: Box): Rests {
  const others: MapRow[] = [[1, 0, 0, 1, 0, 0], ...maps.filter((_, i) => i !== index)];
  const all = others.map((map) => cornersOf(map, frame));
  return {
    points: all.flatMap((corners) => [corners.origin, corners.x, corners.y, corners.turn, middleOf(corners)]),
    edges: all.flatMap(sides),
  };
}

const away = (p: World, q: World): number => Math.hypot(p.x - q.x, p.y - q.y);

/** The nearest of some points, where it is within reach. */
function nearest(points: readonly World[], to: World, reach: number): World | null {
  let found: World | null = null;
  for (const point of points) if (away(point, to) < (found ? away(found, to) : reach)) found = point;
  return found;
}

/** The foot of the perpendicular, kept between the ends. */
function footOn([p, q]: [World, World], to: World): World {
  const [dx, dy] = [q.x - p.x, q.y - p.y];
  const square = dx * dx + dy * dy;
  const s = square > 0 ? Math.min(1, Math.max(0, ((to.x - p.x) * dx + (to.y - p.y) * dy) / square)) : 0;
  return world(p.x + s * dx, p.y + s * dy);
}

/** A point rests at a point before it rests at an edge. */
function restFor(to: World, { points, edges }: Rests, reach: number): World | null {
  const at = (edge: [World, World]) => footOn(edge, to);
  return nearest(points, to, reach) ?? nearest(edges.map(at), to, reach);
}

/** On the ray from `from` with the nearest round angle, as far out as `to`. */
function onRay(from: World, to: World, reach: number): World | null {
  const far = away(from, to);
  const step = ANGLE * DEGREE;
  const angle = Math.round(Math.atan2(to.y - from.y, to.x - from.x) / step) * step;
  const there = world(from.x + far * Math.cos(angle), from.y + far * Math.sin(angle));
  return away(there, to) < reach ? there : null;
}

/**
 * The map whose grip was dragged to `to`, once it has come to rest, and where that is; without a rest within reach it
 * is just dragged. Moved as a whole, any corner of it may rest, or its middle.
 */
export function snapped(
  map: MapRow,
  frame: Box,
  grip: Grip,
  to: World,
  rests: Rests,
  reach: number,
): { map: MapRow; at: World | null } {
  const free = dragged(map, frame, grip, to);
  const now = cornersOf(free, frame);
  if (grip === "origin") {
    const held = [now.origin, now.x, now.y, now.turn, middleOf(now)];
    const by = (choose: (point: World) => World | null) => {
      const found = held.flatMap((point) => {
        const rest = choose(point);
        return rest ? [{ point, rest }] : [];
      });
      return found.sort((p, q) => away(p.point, p.rest) - away(q.point, q.rest))[0];
    };
    const best =
      by((point) => nearest(rests.points, point, reach)) ?? by((point) => restFor(point, rests, reach));
    if (!best) return { map: clean(free), at: null };
    const there = world(to.x + best.rest.x - best.point.x, to.y + best.rest.y - best.point.y);
    return { map: clean(dragged(map, frame, grip, there)), at: best.rest };
  }
  const rest = nearest(rests.points, to, reach) ?? onRay(now.origin, to, reach) ?? restFor(to, rests, reach);
  return rest ? { map: clean(dragged(map, frame, grip, rest)), at: rest } : { map: clean(free), at: null };
}

/** Without the dust of sums: a corner that has come to rest is exactly there. */
const clean = (map: MapRow): MapRow => map.map((x) => Number(x.toFixed(15)) || 0) as MapRow;

/** The map turned about its middle until its arm points at `to`; `free` of round angles, or at one that is near. */
export function spun(map: MapRow, frame: Box, to: World, free: boolean): MapRow {
  const corners = cornersOf(map, frame);
  const middle = middleOf(corners);
  if (!(away(middle, to) > 0)) return map;
  const by = Math.atan2(to.y - middle.y, to.x - middle.x) - angleOf(armOf(corners));
  const side = angleOf([corners.x.x - corners.origin.x, corners.x.y - corners.origin.y]);
  const round = Math.round((side + by) / (ANGLE * DEGREE)) * ANGLE * DEGREE;
  const angle = free || Math.abs(round - side - by) > NEAR_ANGLE * DEGREE ? by : round - side;
  return clean(turned(map, frame, angle));
}
