/** Shapes of some of the nine cells of a square: each piece is the whole, a third as large, in its cell. */
import type { Connectedness, MapRow } from "#wasm/api";
import type { Point } from "../../kit/maps/pieces";

/** Cells are counted row by row from the lower left. */
const column = (cell: number) => cell % 3;
const row = (cell: number) => Math.floor(cell / 3);
const THIRD = 1 / 3;

export function mapsOf(cells: readonly number[]): MapRow[] {
  return cells.map((cell): MapRow => [THIRD, 0, 0, THIRD, column(cell) * THIRD, row(cell) * THIRD]);
}

/** The corners of a cell, counter-clockwise. */
export function cornersOf(cell: number): Point[] {
  const [x, y] = [column(cell) * THIRD, row(cell) * THIRD];
  return [
    [x, y],
    [x + THIRD, y],
    [x + THIRD, y + THIRD],
    [x, y + THIRD],
  ];
}

type Pair = readonly [number, number];

/** Whether one dot has a line to each of the others, and there are no other lines. */
export function isStar(count: number, overlaps: readonly Pair[]): boolean {
  if (count < 5 || overlaps.length !== count - 1) return false;
  return Array.from({ length: count }, (_, i) => i).some((middle) =>
    overlaps.every((pair) => pair.includes(middle)),
  );
}

/** Whether the cells hang together by whole edges. */
export function hangTogether(cells: readonly number[]): boolean {
  const [first] = cells;
  if (first === undefined) return false;
  const found = new Set([first]);
  for (const cell of found)
    for (const other of cells)
      if (Math.abs(column(cell) - column(other)) + Math.abs(row(cell) - row(other)) === 1) found.add(other);
  return found.size === cells.length;
}

/** Two cells at least that share edges, and a shape that is proved to be in pieces. */
export function isDeceiving(cells: readonly number[], answer: Connectedness): boolean {
  return cells.length > 1 && hangTogether(cells) && answer.verdict === "disconnected";
}
