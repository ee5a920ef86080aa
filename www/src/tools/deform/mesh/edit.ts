/** What the hand, the keys and the fields do to the mesh. */

import { signal } from "@preact/signals";
import { announce } from "#document/notice";
import { weightsAt } from "#geometry/bezier";
import type { Mesh, Point } from "#geometry/mesh";
import * as messages from "../messages";
import { chosen, lead, mesh, setMoves } from "./mesh-state";

// Editing alike on both sides: which control point answers which, and how.

/** Mirrored left to right, up and down, or turned by half a turn. */
export type Symmetry = "off" | "sides" | "levels" | "point";

/** How the hand edits; no part of the document. */
export const symmetry = signal<Symmetry>("off");

type Sides = Pick<Mesh, "columns" | "rows">;

/** The control point that answers one. */
export function partner({ columns, rows }: Sides, index: number, by: Symmetry): number {
  const column = index % columns;
  const row = (index - column) / columns;
  const across = by === "sides" || by === "point" ? columns - 1 - column : column;
  const up = by === "levels" || by === "point" ? rows - 1 - row : row;
  return up * columns + across;
}

/** How its displacement answers: the factors of dx and dy. */
function answer(by: Symmetry): readonly [number, number] {
  return [by === "sides" || by === "point" ? -1 : 1, by === "levels" || by === "point" ? -1 : 1];
}

/**
 * What each control point moves by when those chosen move by (dx, dy): they and, mirrored, their partners. Of two
 * chosen partners the one nearer to the one that is held leads; one on the axis stays on it.
 */
export function spread(
  mesh: Sides,
  chosen: Iterable<number>,
  held: number,
  [dx, dy]: readonly [number, number],
  by: Symmetry,
): Map<number, readonly [number, number]> {
  const out = new Map<number, readonly [number, number]>();
  const all = new Set(chosen);
  const [fx, fy] = answer(by);
  for (const index of all) {
    const other = partner(mesh, index, by);
    if (by === "off") out.set(index, [dx, dy]);
    else if (other === index) out.set(index, [((1 + fx) / 2) * dx, ((1 + fy) / 2) * dy]);
    else if (!all.has(other) || leads(mesh, index, other, held)) {
      out.set(index, [dx, dy]);
      out.set(other, [fx * dx, fy * dy]);
    }
  }
  return out;
}

function leads(mesh: Sides, index: number, other: number, held: number): boolean {
  const gap = distance(mesh, index, held) - distance(mesh, other, held);
  return gap === 0 ? index < other : gap < 0;
}

function distance({ columns }: Sides, p: number, q: number): number {
  return Math.hypot((p % columns) - (q % columns), Math.floor(p / columns) - Math.floor(q / columns));
}

// Pulling at any place of the mesh: the least moves of the control points that take the place along.

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

/** The moves, with those handles (and, mirrored, their partners) moved on by (dx, dy). */
export function shifted(
  from: readonly number[],
  handles: Iterable<number>,
  held: number,
  by: Point,
): number[] {
  const moves = from.slice();
  for (const [index, [dx, dy]] of spread(mesh.peek(), handles, held, by, symmetry.peek())) {
    moves[2 * index] = (moves[2 * index] ?? 0) + dx;
    moves[2 * index + 1] = (moves[2 * index + 1] ?? 0) + dy;
  }
  return moves;
}

/** The moves, with the place (u, v) of the mesh pulled along by (dx, dy). */
export function pulled(from: readonly number[], place: Point, by: Point): number[] {
  const more = pullMoves(mesh.peek(), place, by, symmetry.peek());
  return from.map((x, i) => x + (more[i] ?? 0));
}

/** One step of the keys: the handle, and with it all that are chosen if it is one of them. */
export function nudge(index: number, by: Point, gesture: string): void {
  const all = chosen.peek();
  setMoves(shifted(mesh.peek().moves, all.has(index) ? all : [index], index, by), gesture);
}

/** Puts handles, and their partners, back to where they rest: those chosen, or else the one that keys act on. */
export function resetChosen(): void {
  const all = chosen.peek().size > 0 ? [...chosen.peek()] : [lead.peek()];
  const by = symmetry.peek();
  reset(new Set(all.flatMap((index) => [index, partner(mesh.peek(), index, by)])));
  announce(all.length === 1 ? messages.handleReset : messages.handlesReset(all.length));
}

/** Puts all handles back at the present moment. */
export function resetAll(): void {
  reset(new Set(mesh.peek().moves.keys()));
  announce(messages.allHandlesReset);
}

function reset(handles: ReadonlySet<number>): void {
  setMoves(mesh.peek().moves.map((x, i) => (handles.has(Math.floor(i / 2)) ? 0 : x)));
}
