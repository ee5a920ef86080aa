import { describe, expect, it } from "vitest";
import { crossingWords, matchWords, sizeWords, unlikeWords, wayWords, whyWords } from "./words";

const knots = (count: number): [number, number][] => Array.from({ length: count }, (_, i) => [i, i * i]);

describe("what is said of a curve", () => {
  it("counts knots and copies", () => {
    expect(sizeWords({ knots: knots(3), edges: [null, null, null] })).toBe("3 knots");
    const copy = { from: 0, span: 2, reversed: false, c: 0.5 };
    expect(sizeWords({ knots: knots(3), edges: [null, copy, null] })).toBe("3 knots, 1 copy");
    expect(sizeWords({ knots: knots(4), edges: [copy, copy, null, null] })).toBe("4 knots, 2 copies");
  });

  it("tells how often it crosses itself, and nothing where it does not", () => {
    expect([0, 1, 2, 7].map(crossingWords)).toEqual([
      "",
      "crosses itself once",
      "crosses itself twice",
      "crosses itself 7 times",
    ]);
  });

  it("tells how knots were brought together", () => {
    expect(matchWords(60, 64, 64)).toBe(
      "60 knots of A become knots of B. The other 4 knots grow out of an edge or shrink into one.",
    );
    expect(matchWords(12, 12, 12)).toBe("12 knots of A become knots of B. Every knot has its partner.");
    expect(matchWords(12, 13, 13)).toBe(
      "12 knots of A become knots of B. The other knot grows out of an edge or shrinks into one.",
    );
    // Refined so far that nothing can be said of partners.
    expect(matchWords(10, 10, 30)).toBe("30 knots during the morph.");
  });

  it("does not promise a way without crossings where there are some", () => {
    expect(wayWords(0)).toContain("nothing can come apart");
    expect(wayWords(35)).toContain("crosses itself 35 times");
    expect(wayWords(35)).not.toContain("nothing");
  });

  it("tells of a stalk where few knots have a partner and the curve crosses itself", () => {
    expect(unlikeWords(102, 116, 213, 35)).toContain("stalk");
    expect(unlikeWords(102, 116, 213, 0)).toBeNull();
    expect(unlikeWords(102, 116, 150, 3)).toBeNull();
  });

  it("says why it holds together, of a morph and of one curve", () => {
    expect(whyWords({ a: "Maple leaf", b: "Oak leaf" })).toContain("between Maple leaf and Oak leaf");
    expect(whyWords(null)).not.toContain("between");
  });
});
