/** What a press meets. */

import { type GridLine, gridLines } from "#geometry/bezier";
import { type Screen, screen, toScreen, toWorld, type View, world } from "#geometry/coordinates";
import { type Mesh, type Point, placed } from "#geometry/mesh";
import { effectiveView, stageSize } from "#stage/view";

export function onStage([x, y]: Point): Screen {
  return toScreen(world(x, y), effectiveView.value, stageSize.value);
}

/** A way on the stage as a way in the plane. */
export function inPlane(from: Screen, to: Screen, { scale }: Pick<View, "scale">): Point {
  return [(to.x - from.x) / scale, (from.y - to.y) / scale];
}

export function handlesOf(mesh: Mesh): Screen[] {
  return Array.from({ length: mesh.columns * mesh.rows }, (_, i) => onStage(placed(mesh, i)));
}

/** The nearest of some points within reach, by number, or -1: handles that lie close share the room between them. */
export function nearest(points: readonly Screen[], to: Screen, reach: number): number {
  let best = -1;
  let least = reach;
  points.forEach(({ x, y }, i) => {
    const far = Math.hypot(x - to.x, y - to.y);
    if (far < least || (far === least && best < 0)) [best, least] = [i, far];
  });
  return best;
}

/** Which points lie in the rectangle between two corners. */
export function inside(points: readonly Screen[], p: Screen, q: Screen): number[] {
  const [x0, x1] = [Math.min(p.x, q.x), Math.max(p.x, q.x)];
  const [y0, y1] = [Math.min(p.y, q.y), Math.max(p.y, q.y)];
  return points.flatMap(({ x, y }, i) => (x >= x0 && x <= x1 && y >= y0 && y <= y1 ? [i] : []));
}

/** Lines of the display grid each way (Fujimoto et al., section 5.3). */
export const LINES = 11;

/** The crossing of the display grid nearest to a press, as a place of the box, or null. */
export function crossingAt(mesh: Mesh, to: Screen, reach: number): { place: Point; at: Screen } | null {
  const points = gridLines(mesh, LINES)
    .slice(0, LINES)
    .flatMap((line: GridLine) => line.points.map(onStage));
  const index = nearest(points, to, reach);
  const at = points[index];
  if (!at) return null;
  const up = index % LINES;
  return { place: [(index - up) / LINES / (LINES - 1), up / (LINES - 1)], at: screen(at.x, at.y) };
}

/** A place on the stage as a point of the plane. */
export function onPlane(at: Screen): Point {
  const { x, y } = toWorld(at, effectiveView.peek(), stageSize.peek());
  return [x, y];
}
