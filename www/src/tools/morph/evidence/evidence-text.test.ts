import { describe, expect, it } from "vitest";
import type { Connectedness } from "#wasm/api";
import { accountOf, addressWords, checkWords, clusterWords, gapWords, linkWords } from "./evidence-text";

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
  it("says so where the gap is too narrow to be seen, and counts no pieces", () => {
    const broken = (upper: number) =>
      accountOf(answer({ verdict: "disconnected", count: 3, gap: { lower: upper / 2, upper } }), 1 / 600);
    expect(broken(2e-4)).toContain("narrower than 1/600");
    expect(broken(0.2)).not.toContain("narrower");
    for (const words of [broken(2e-4), broken(0.2)]) expect(words).not.toMatch(/three|3 pieces/);
  });

  it("names the resolution that it was looked at with", () => {
    expect(accountOf(answer({}), 1 / 600)).toMatch(/within 1\/600 .* not proved/);
    expect(accountOf(answer({}), 1 / 4800)).toContain("1/4800");
  });
});

describe("gapWords", () => {
  it("tells per cents of the diameter, and its bounds in the unit of the plane, no finer than needed", () => {
    const of = (lower: number, upper: number) =>
      gapWords(answer({ verdict: "disconnected", gap: { lower, upper } }));
    expect(of(0.021, 0.034)).toBe("1.7% of the diameter: between 0.021 and 0.034 in units of the plane");
    expect(of(0.02131, 0.02134)).toBe(
      "1.1% of the diameter: between 0.02131 and 0.02134 in units of the plane",
    );
    expect(of(0.5, 0.5)).toBe("25% of the diameter: 0.50000 in units of the plane");
  });

  it("gives only what is known", () => {
    expect(gapWords(answer({ verdict: "connected" }))).toBeNull();
    expect(gapWords(answer({ verdict: "no-attractor", gap: { lower: 0, upper: Infinity } }))).toBeNull();
    expect(gapWords(answer({ gap: { lower: 0, upper: 1e-3 } }))).toBe(
      "at most 0.05% of the diameter: 0.0010 in units of the plane",
    );
    expect(gapWords(answer({ gap: { lower: 0, upper: 1e-3 }, diameter: 0 }))).toBe(
      "at most 0.0010 in units of the plane",
    );
  });
});

describe("clusterWords", () => {
  it("writes clusters of pieces as sets, counted from 1, the largest first", () => {
    expect(clusterWords([0, 0, 0])).toBe("{1,2,3}");
    expect(clusterWords([0, 1, 0])).toBe("{1,3} | {2}");
    expect(clusterWords([0, 1, 2])).toBe("{1} | {2} | {3}");
    expect(clusterWords([])).toBe("");
  });

  it("draws long runs together", () => {
    expect(clusterWords([0, 0, 0, 0, 1, 0])).toBe("{1 to 4,6} | {5}");
  });
});

describe("links and checks", () => {
  it("reads a shared point with its addresses", () => {
    expect(linkWords({ kind: "point", pair: [0, 1], words: ["1(2)", "2(1)"], at: [-0.25, 5.6e-17] })).toBe(
      "Pieces 1 and 2 share the point (−0.25, 0), address 1(2) = 2(1).",
    );
  });

  it("says how copies of one shape and direction meet", () => {
    const words = linkWords({ kind: "difference", pair: [0, 2], words: ["1", "3"], at: [0, 0] });
    expect(words).toMatch(/^Pieces 1 and 3 meet: the step from one to the other/);
  });

  it("explains an address", () => {
    expect(addressWords("1(2)")).toBe(
      "1(2) is short for 12222…: each digit is a piece inside the previous one.",
    );
    expect(addressWords("12(31)")).toBe(
      "12(31) is short for 12313…: each digit is a piece inside the previous one.",
    );
    expect(addressWords("12.3.(10)")).toBe(
      "12.3.(10) is short for 12.3.10.10.10…: each digit is a piece inside the previous one.",
    );
    expect(addressWords(".(12)")).toMatch(/^\.\(12\) is short for 12\.12\.12\.12\.12…/);
    expect(addressWords("3.3.3.3.(1.2)")).toMatch(/short for 3\.3\.3\.3\.1\.2…/);
    expect(addressWords("3333(12)")).toMatch(/short for 333312…/);
    for (const none of ["nonsense", "", "()", ".(.)", "1()"]) expect(addressWords(none)).toBe("");
  });

  it("says what was checked, or what is wrong", () => {
    expect(checkWords({ valid: true, text: "", pairs: 47, links: 0, longest: 9 })).toBe(
      "Verified in exact arithmetic: 47 pairs of pieces, up to level 9.",
    );
    expect(checkWords({ valid: true, text: "", pairs: 1, links: 0, longest: 1 })).toBe(
      "Verified in exact arithmetic: 1 pair of pieces, at level 1.",
    );
    expect(checkWords({ valid: true, text: "", pairs: 0, links: 3, longest: 13 })).toBe(
      "Verified in exact arithmetic: 3 contacts, pieces up to level 13.",
    );
    expect(checkWords({ valid: true, text: "", pairs: 0, links: 1, longest: 1 })).toBe(
      "Verified in exact arithmetic: 1 contact, pieces at level 1.",
    );
    expect(checkWords({ valid: false, text: "A pair overlaps.", pairs: 0, links: 0, longest: 0 })).toBe(
      "The check failed: A pair overlaps.",
    );
  });
});
