/** How a game of reaching a cell stands. */
import { orbitOf } from "#geometry/maps/orbit";
import { type Board, cellOf, fewest, isIn, middleOf } from "#geometry/maps/target";
import type { Game } from "./words";

/** What is asked for, and what was thrown so far, the first throw first. */
export interface Asked {
  target: readonly number[];
  letters: readonly number[];
  /** The throws are those that were shown. */
  shown: boolean;
}

export function gameOf(board: Board, { target, letters, shown }: Asked): Game {
  const way = fewest(board, target);
  const here = orbitOf(board.maps, board.start, letters).at(-1) ?? board.start;
  const reached = isIn(board, target, here);
  const cell = cellOf(board, target);
  const xs = cell.map(([x]) => x);
  const where = { here, centre: middleOf(cell), width: Math.max(...xs) - Math.min(...xs) };
  return { throws: letters.length, reached, least: way.length, shown, target, way, where };
}
