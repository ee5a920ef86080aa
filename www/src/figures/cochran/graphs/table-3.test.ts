import { describe, expect, it } from "vitest";
import { TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import known from "../../../../../tests/known/fit/hidden_variable.json";
import { TABLE_3, TABLE_3_EXACT } from "./printed-tables";
import { breakpoints, fractionWords, missesOf, valueAt } from "./table-3";

describe("Table 3", () => {
  it("makes the function that it is known to make", () => {
    for (const [k, value] of known.curve.table3_F_at_k243.entries()) {
      expect(valueAt(TABLE_3_EXACT, k / 243)).toBeCloseTo(value, 6);
    }
  });

  it("is as far from the original as the paper says, to what it leaves open", () => {
    // The paper: 0.0858 at most and 0.000180 in the mean square. Its digits are between those of the fractions and of
    // the rounded table.
    const exact = missesOf(TABLE_3_EXACT);
    expect(exact.worst).toBeCloseTo(0.08203, 5);
    expect(exact.meanSquare).toBeCloseTo(0.000157, 6);
    expect(exact.all).toHaveLength(2 * 2188);
    const rounded = missesOf(TABLE_3);
    expect(rounded.worst).toBeCloseTo(0.08861, 5);
    expect(rounded.meanSquare).toBeCloseTo(0.000183, 6);
  });

  it("joins the pieces of the fractions", () => {
    expect(breakpoints(TABLE_3_GRAPH).map(fractionWords)).toEqual([
      "0",
      "7/54",
      "13/54",
      "1/3",
      "2/3",
      "41/54",
      "47/54",
      "1",
    ]);
  });

  it("has no value without pieces", () => {
    expect(valueAt([], 0.5)).toBeNaN();
  });
});

describe("a fraction in words", () => {
  it("is found where the value is one", () => {
    expect([0.5, 1 / 3, 5 / 18, 22 / 27, 1].map(fractionWords)).toEqual(["1/2", "1/3", "5/18", "22/27", "1"]);
    expect(fractionWords(Math.PI - 3)).toBe("0.1416");
  });
});
