import { describe, expect, it } from "vitest";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { firstDigits, isSameAddress, pieceOf, pointOf, readAddress } from "./address";

const MAPS = gasket(0.5);
const read = (text: string) => {
  const address = readAddress(text, 3);
  if (typeof address === "string") throw new Error(address);
  return address;
};
const point = (text: string) => pointOf(MAPS, read(text));

describe("addresses", () => {
  it("lead to corners, and to where pieces meet by either piece", () => {
    expect(point("(1)")).toEqual([0, 0]);
    expect(point("(3)")?.[1]).toBeCloseTo(HEIGHT, 12);
    for (const text of ["1(2)", "2(1)", "12(2)", "1(22)"]) {
      expect(point(text)?.[0]).toBeCloseTo(0.5, 12);
      expect(point(text)?.[1]).toBeCloseTo(0, 12);
    }
    // 1/3 is 0.010101.. in halves.
    expect(point("(12)")?.[0]).toBeCloseTo(1 / 3, 12);
  });

  it("of finitely many digits are pieces", () => {
    expect(point("13")).toBeNull();
    expect(pieceOf(MAPS, read("13"))[0]).toBe(0.25);
    expect(pieceOf(MAPS, read(""))).toEqual([1, 0, 0, 1, 0, 0]);
    // While it is typed.
    expect(read("1(")).toEqual({ first: [0], again: [] });
    expect(read(" 1 ( 2 )")).toEqual({ first: [0], again: [1] });
  });

  it("are the same however they are written", () => {
    for (const other of ["12(2)", "1(22)", "122(222)"])
      expect(isSameAddress(read("1(2)"), read(other))).toBe(true);
    expect(isSameAddress(read("(12)"), read("1(21)"))).toBe(true);
    for (const [one, other] of [
      ["1(2)", "2(1)"],
      ["(12)", "(121)"],
      ["(112)", "(1121)"],
    ] as const)
      expect(isSameAddress(read(one), read(other)), one).toBe(false);
    expect(firstDigits(read("1(23)"), 6)).toEqual([0, 1, 2, 1, 2, 1]);
    expect(firstDigits(read("13"), 6)).toEqual([0, 2]);
  });

  it.each([
    ["4", "There is no piece 4"],
    ["0", "There is no piece 0"],
    ["1(4)", "There is no piece 4"],
    ["abc", "Write digits"],
    ["(1)2", "Write digits"],
    ["1((2))", "Write digits"],
    ["1".repeat(13), "At most 12"],
    [`(${"1".repeat(9)})`, "At most 8"],
    ["1".repeat(1e6), "At most 12"],
  ])("says what is wrong with %s", (text, words) => {
    expect(readAddress(text, 3)).toContain(words);
  });
});
