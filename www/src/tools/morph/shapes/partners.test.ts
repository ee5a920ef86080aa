import { describe, expect, it } from "vitest";
import { bondWords, partnersOf } from "./partners";

const ROWS = `
one    =+.
two    +==
three  .==
`;

describe("partners", () => {
  it("are read from the row of a shape", () => {
    expect([...partnersOf("one", ROWS)]).toEqual([["two", "other"]]);
    expect([...partnersOf("two", ROWS)]).toEqual([
      ["one", "other"],
      ["three", "plain"],
    ]);
    expect(partnersOf("none", ROWS).size).toBe(0);
  });

  it("are the same from both sides, in the table of the gallery", () => {
    expect(partnersOf("fern").get("maple")).toBe("plain");
    for (const [other, bond] of partnersOf("fern")) expect(partnersOf(other).get("fern")).toBe(bond);
    // It is in pieces itself.
    expect(partnersOf("dust").size).toBe(0);
  });

  it("are told in words", () => {
    expect(bondWords("plain", "Fern")).toBe("Stays in one piece with Fern");
    expect(bondWords("other", "Fern")).toContain("look for the pairing");
  });
});
