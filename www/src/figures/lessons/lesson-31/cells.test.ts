import { expect, it } from "vitest";
import { orbitOf, type Point, piecesAt, preimageOf } from "#geometry/maps/orbit";
import { fewest, isIn } from "#geometry/maps/target";
import { BOARD, BOX, lettersOf, MAPS, MARKED, readSoFar, SOUGHT, WANTED, writtenAs } from "./cells";

it("has a start that is in no piece, so that a cell takes as many throws as it has letters", () => {
  expect([0, 1, 2].some((letter) => isIn(BOARD, [letter], BOARD.start))).toBe(false);
  for (const target of ["1", "33", "132", WANTED, "21321"])
    expect(writtenAs(fewest(BOARD, lettersOf(target)))).toBe([...target].reverse().join(""));
});

it("answers its question: 2, then 3, then 1 leads into 132", () => {
  const last = (written: string) => orbitOf(MAPS, BOARD.start, lettersOf(written)).at(-1) as Point;
  expect(isIn(BOARD, lettersOf("132"), last("231"))).toBe(true);
  expect(isIn(BOARD, lettersOf("132"), last("132"))).toBe(false);
});

it("marks a point that has one address, which the pieces tell one by one", () => {
  let here = MARKED;
  for (const letter of lettersOf(SOUGHT)) {
    expect(piecesAt(MAPS, BOX, here)).toEqual([letter]);
    here = preimageOf(MAPS[letter] ?? [1, 0, 0, 1, 0, 0], here) as Point;
  }
  expect(["", "2", "23", "21", SOUGHT].map(readSoFar)).toEqual(["none", "right", "right", "wrong", "done"]);
});
