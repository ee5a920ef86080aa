/** What the hand, the keys and the fields do to the mesh. */

import { announce } from "#document/notice";
import type { Point } from "#geometry/mesh";
import * as messages from "../messages";
import { mesh, setMoves } from "./document";
import { chosen, lead } from "./handles/chosen";
import { pullMoves } from "./pull";
import { partner, spread, symmetry } from "./symmetry";

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
