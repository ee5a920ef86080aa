/** Pulling at any place of the mesh: the least moves of the control points that take the place along. */

import { weightsAt } from "#geometry/bezier";
import type { Mesh } from "#geometry/mesh";
import { answer, partner, type Symmetry } from "./symmetry";

/**
 * Close to the axis of a mirror, where its partner pulls the other way, a place lags rather than the mesh tears out.
 */
const LEAST_SHARE = 0.05;

/**
 * The moves, dx and dy of each control point, that take the place (u, v) along by (dx, dy): in proportion to how much
 * each point has to say there, which is the least of them in the mean.
 */
export function pullMoves(
  mesh: Pick<Mesh, "columns" | "rows">,
  [u, v]: readonly [number, number],
  [dx, dy]: readonly [number, number],
  by: Symmetry = "off",
): number[] {
  const weights = weightsAt(mesh, u, v);
  const square = weights.reduce((sum, w) => sum + w * w, 0);
  if (by === "off") return weights.flatMap((w) => [(w / square) * dx, (w / square) * dy]);
  const mirrored = weights.map((_, i) => weights[partner(mesh, i, by)] ?? 0);
  const cross = weights.reduce((sum, w, i) => sum + w * (mirrored[i] ?? 0), 0);
  const [fx, fy] = answer(by);
  const along = (wanted: number, factor: number) =>
    wanted / Math.max(square + factor * cross, LEAST_SHARE * square);
  const [px, py] = [along(dx, fx), along(dy, fy)];
  return weights.flatMap((w, i) => [(w + fx * (mirrored[i] ?? 0)) * px, (w + fy * (mirrored[i] ?? 0)) * py]);
}
