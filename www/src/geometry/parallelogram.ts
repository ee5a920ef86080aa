import type { MapRow } from "#wasm/api";
import type { Box } from "./boxes";
import { type World, world } from "./coordinates";

/** The parts of a parallelogram that can be taken hold of. */
export type Grip = "origin" | "x" | "y" | "turn";

export const GRIPS: readonly Grip[] = ["origin", "x", "y", "turn"];

export interface Corners {
  origin: World;
  x: World;
  y: World;
  turn: World;
}

/** Where a map takes a point. */
export function applied([a, b, c, d, e, f]: MapRow, x: number, y: number): World {
  return world(a * x + b * y + e, c * x + d * y + f);
}

/** The image of the frame under a map: its lower left corner, the ends of both sides there, and the far corner. */
export function cornersOf(map: MapRow, frame: Box): Corners {
  return {
    origin: applied(map, frame.x0, frame.y0),
    x: applied(map, frame.x1, frame.y0),
    y: applied(map, frame.x0, frame.y1),
    turn: applied(map, frame.x1, frame.y1),
  };
}

/** The middle of a parallelogram. */
export function middleOf({ x, y }: Corners): World {
  return world((x.x + y.x) / 2, (x.y + y.y) / 2);
}

export function angleOf([x, y]: readonly [number, number]): number {
  return Math.atan2(y, x);
}

/** The direction from the middle in which the handle stands that turns it: along its second side, of length 1. */
export function armOf({ origin, x, y }: Corners): [number, number] {
  const up: [number, number] = [y.x - origin.x, y.y - origin.y];
  const across: [number, number] = [origin.y - x.y, x.x - origin.x];
  for (const [dx, dy] of [up, across]) {
    const length = Math.hypot(dx, dy);
    if (length > 0) return [dx / length, dy / length];
  }
  return [0, 1];
}

/** The map turned by an angle about the middle of its parallelogram. */
export function turned([a, b, c, d, e, f]: MapRow, frame: Box, by: number): MapRow {
  const [cos, sin] = [Math.cos(by), Math.sin(by)];
  const [x, y] = [(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2];
  const [p, q, r, s] = [cos * a - sin * c, cos * b - sin * d, sin * a + cos * c, sin * b + cos * d];
  return [p, q, r, s, (a - p) * x + (b - q) * y + e, (c - r) * x + (d - s) * y + f];
}

/**
 * The map whose parallelogram has one grip at `to`. The origin moves the whole; an end of a side moves that side alone;
 * the far corner turns and scales the whole about the origin. A drag that would ask the impossible changes nothing.
 */
export function dragged(map: MapRow, frame: Box, grip: Grip, to: World): MapRow {
  const [a, b, c, d, e, f] = map;
  const { origin, turn } = cornersOf(map, frame);
  const width = frame.x1 - frame.x0;
  const height = frame.y1 - frame.y0;
  switch (grip) {
    case "origin":
      return [a, b, c, d, e + to.x - origin.x, f + to.y - origin.y];
    case "x":
      if (!(width > 0)) return map;
      return about([(to.x - origin.x) / width, b, (to.y - origin.y) / width, d], frame, origin);
    case "y":
      if (!(height > 0)) return map;
      return about([a, (to.x - origin.x) / height, c, (to.y - origin.y) / height], frame, origin);
    case "turn": {
      // The complex number that takes the old diagonal to the new one.
      const px = turn.x - origin.x;
      const py = turn.y - origin.y;
      const qx = to.x - origin.x;
      const qy = to.y - origin.y;
      const square = px * px + py * py;
      if (!(square > 0)) return map;
      const re = (qx * px + qy * py) / square;
      const im = (qy * px - qx * py) / square;
      const linear = [re * a - im * c, re * b - im * d, im * a + re * c, im * b + re * d] as const;
      return about(linear, frame, origin);
    }
  }
}

/** The map with this linear part that takes the frame's lower left corner to `origin`. */
function about([a, b, c, d]: readonly [number, number, number, number], frame: Box, origin: World): MapRow {
  return [a, b, c, d, origin.x - a * frame.x0 - b * frame.y0, origin.y - c * frame.x0 - d * frame.y0];
}
