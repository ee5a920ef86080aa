/** The board of the game: the gasket, its triangle, and a point in the middle, which is in no piece. */
import { pointAt } from "#geometry/maps/orbit";
import { type Board, DEEPEST } from "#geometry/maps/target";
import { gasket, HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { type Field, text } from "../../kit/state/fields";

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

/**
 * The target as it stands in links: two consonants for its place among all cells, so that nobody reads the answer off
 * them at a glance. First links had its letters, "213", and open for ever.
 */
export const HIDDEN: Field<string> = {
  write(target) {
    const code = (placeOf(target) * STRIDE) % CODES;
    return `${MARKS[Math.floor(code / MARKS.length)]}${MARKS[code % MARKS.length]}`;
  },
  read(written) {
    const plain = letters(1, DEEPEST).read(written);
    if (plain !== null) return plain;
    const [high, low] = [...written].map((mark) => MARKS.indexOf(mark));
    if (written.length !== 2 || high === undefined || low === undefined || high < 0 || low < 0) return null;
    const code = MARKS.length * high + low;
    if (code >= CODES) return null;
    return targetAt((code * BACK) % CODES);
  },
};

const MARKS = "bcdfghjklmnpqrstvwxz";
/** A prime above the number of cells, 363; a factor that scatters them, and its inverse: 141 · 177 = 68 · 367 + 1. */
const CODES = 367;
const STRIDE = 141;
const BACK = 177;

/** Counted from 1, the shortest first: in base 3 with the digits 1 to 3. */
const placeOf = (target: string): number =>
  [...target].reduce((place, digit) => 3 * place + Number(digit), 0);

/** Null where there is no such cell. */
function targetAt(place: number): string | null {
  let target = "";
  for (let left = place; left > 0; left = Math.floor((left - 1) / 3))
    target = `${((left - 1) % 3) + 1}${target}`;
  return target === "" || target.length > DEEPEST ? null : target;
}

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
