import { describe, expect, it } from "vitest";
import type { Connectedness } from "../../engine/api";
import {
  accountOf,
  addressWords,
  checkWords,
  gapWords,
  groupWords,
  linkWords,
  numbersWords,
  shareWords,
} from "./words";

const answer = (of: Partial<Connectedness>): Connectedness => ({
  verdict: "touching",
  gap: { lower: 0, upper: 0 },
  overlaps: [],
  components: [0, 0],
  count: 1,
  diameter: 2,
  nodes: 12,
  ...of,
});

describe("accountOf", () => {
  it("claims a proof only for proofs", () => {
    const proved = (of: Partial<Connectedness>) =>
      /is proved/.test(accountOf(answer(of)).why.replace("not proved", ""));
    expect(proved({ verdict: "connected" })).toBe(true);
    expect(proved({ verdict: "disconnected", count: 2, gap: { lower: 0.5, upper: 0.6 } })).toBe(true);
    expect(proved({ verdict: "touching" })).toBe(false);
    expect(proved({ verdict: "undecided" })).toBe(false);
    expect(proved({ verdict: "no-attractor" })).toBe(false);
  });

  it("says so where the gap is too narrow to be seen", () => {
    const narrow = accountOf(
      answer({ verdict: "disconnected", count: 3, gap: { lower: 1e-4, upper: 2e-4 } }),
    );
    expect(narrow.title).toBe("No gap can be seen, but there is one.");
    expect(narrow.why).toContain("three pieces");
  });
});

describe("gapWords", () => {
  it("tells bounds apart, and no finer", () => {
    const of = (lower: number, upper: number) =>
      gapWords(answer({ verdict: "disconnected", gap: { lower, upper } }));
    expect(of(0.021, 0.034)).toBe("between 0.021 and 0.034, 1.7% of its size");
    expect(of(0.02131, 0.02134)).toBe("between 0.02131 and 0.02134, 1.1% of its size");
    expect(of(0.5, 0.5)).toBe("0.50000, 25% of its size");
  });

  it("gives only what is known", () => {
    expect(gapWords(answer({ verdict: "connected" }))).toBeNull();
    expect(gapWords(answer({ verdict: "no-attractor", gap: { lower: 0, upper: Infinity } }))).toBeNull();
    expect(gapWords(answer({ gap: { lower: 0, upper: 1e-3 } }))).toBe("at most 0.0010, 0.05% of its size");
    expect(gapWords(answer({ gap: { lower: 0, upper: 1e-3 }, diameter: 0 }))).toBe("at most 0.0010");
  });
});

describe("numbers", () => {
  it("counts from 1 and draws runs together", () => {
    expect(numbersWords([0, 1, 2, 4])).toBe("1 to 3 and 5");
    expect(numbersWords([0, 1])).toBe("1 and 2");
    expect(numbersWords([3])).toBe("4");
    expect(numbersWords([])).toBe("");
  });

  it("says hundredths", () => {
    expect(shareWords(0.0031)).toBe("0.31%");
    expect(shareWords(0.5)).toBe("50%");
    expect(shareWords(1e-9)).toBe("less than 0.001%");
    expect(shareWords(Number.POSITIVE_INFINITY)).toBe("");
  });
});

describe("groupWords", () => {
  it("names who hangs together and who stands alone", () => {
    expect(groupWords([0, 0, 0])).toEqual(["All 3 pieces hang together."]);
    expect(groupWords([4, 4])).toEqual(["Both pieces hang together."]);
    expect(groupWords([0])).toEqual(["There is a single piece."]);
    expect(groupWords([0, 1, 0])).toEqual(["Pieces 1 and 3 hang together.", "Piece 2 stands alone."]);
    expect(groupWords([0, 1, 2])).toEqual(["Pieces 1 to 3 stand alone, each by itself."]);
    expect(groupWords([])).toEqual([]);
  });
});

describe("links and checks", () => {
  it("reads a shared point with its addresses", () => {
    expect(linkWords({ kind: "point", pair: [0, 1], words: ["1(2)", "2(1)"], at: [-0.25, 5.6e-17] })).toBe(
      "Pieces 1 and 2 share the point (−0.25, 0), address 1(2) = 2(1).",
    );
  });

  it("explains an address", () => {
    expect(addressWords("1(2)")).toBe(
      "1(2) is short for 12222…: each letter is a piece within the one before.",
    );
    expect(addressWords("12(31)")).toBe(
      "12(31) is short for 12313…: each letter is a piece within the one before.",
    );
    expect(addressWords("11 3(2 12)")).toMatch(/^In an address each letter/);
    expect(addressWords("nonsense")).toBe("");
  });

  it("says what was checked, or what is wrong", () => {
    expect(checkWords({ valid: true, text: "", pairs: 47, longest: 9 })).toBe(
      "Checked in exact arithmetic: 47 pairs of pieces, words of up to 9 letters.",
    );
    expect(checkWords({ valid: true, text: "", pairs: 1, longest: 1 })).toBe(
      "Checked in exact arithmetic: 1 pair of pieces, words of one letter.",
    );
    expect(checkWords({ valid: false, text: "A pair overlaps.", pairs: 2, longest: 3 })).toBe(
      "The check failed: A pair overlaps.",
    );
  });
});
