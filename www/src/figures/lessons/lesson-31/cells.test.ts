import { expect, it } from "vitest";
import { orbitOf, type Point, piecesAt, preimageOf } from "#geometry/maps/orbit";
import { fewest, isIn } from "#geometry/maps/target";
import { BOARD, BOX, HIDDEN, lettersOf, MAPS, MARKED, readSoFar, SOUGHT, WANTED, writtenAs } from "./cells";

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

it("hides its target in the link, reads every one back, and still reads first links, which had it plainly", () => {
  const targets = [""];
  for (const target of targets)
    if (target.length < 5) targets.push(...["1", "2", "3"].map((next) => `${target}${next}`));
  const written = targets.slice(1).map((target) => HIDDEN.write(target));
  expect(new Set(written).size).toBe(363);
  expect(written.filter((one) => !/^[a-z]{2}$/.test(one))).toEqual([]);
  expect(written.map((one) => HIDDEN.read(one))).toEqual(targets.slice(1));
  for (const plain of ["3", "13", "213", "21321"]) expect(HIDDEN.read(plain)).toBe(plain);
});

it.each(["", "b", "bb", "zz", "aa", "bcd", "4", "213213", "0"])("reads no target from “%s”", (written) => {
  expect(HIDDEN.read(written)).toBeNull();
});

it("keeps what it wrote into links", () => {
  expect(["1", "213", "21321"].map(HIDDEN.write)).toEqual(["kc", "gc", "ql"]);
});
