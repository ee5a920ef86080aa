/** The board of the game: the gasket, its triangle, and a point in the middle, which is in no piece. */
import { pointAt } from "#geometry/maps/orbit";
import type { Board } from "#geometry/maps/target";
import { gasket, HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { text } from "../../kit/state/fields";

export const MAPS = gasket(0.5);
export const BOX = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const TRIANGLE: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];
export const BOARD: Board = { maps: MAPS, hull: TRIANGLE, start: [0.5, HEIGHT / 3] };

/** Letters as they stand in the address of the page, at least and at most so many. */
export const letters = (least: number, most: number) => text(new RegExp(`[123]{${least},${most}}`));
export const lettersOf = (written: string): number[] => [...written].map((digit) => Number(digit) - 1);
export const writtenAs = (all: readonly number[]): string => all.map((letter) => letter + 1).join("");

/** What is to be reached in the first exercise, and with how many throws. */
export const WANTED = "3121";
/** The cell of four letters that the marked point of the second one lies in. */
export const SOUGHT = "2312";
/** A point inside of that cell, and on no edge of smaller ones. */
export const MARKED: Point = pointAt(MAPS, lettersOf(`${SOUGHT}13213`));

/** How far an address is right, and what is wrong after that. */
export function readSoFar(said: string): "none" | "right" | "done" | "wrong" {
  if (said === "") return "none";
  if (!SOUGHT.startsWith(said)) return "wrong";
  return said === SOUGHT ? "done" : "right";
}
