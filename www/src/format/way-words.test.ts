import { describe, expect, it } from "vitest";
import { offerWords, triedWords } from "./way-words";

const holds = { holds: true, gap: 0 };

describe("offerWords", () => {
  it("says what a way is worth before it says why", () => {
    const words = offerWords({ kind: "joints", about: "All joints stay joined." }, holds, 0.08);
    expect(words).toEqual({
      what: "Joint by joint it holds together all the way, but for rounding.",
      why: "All joints stay joined.",
    });
    expect(offerWords({ kind: "correspondence", about: "" }, holds, 0.08).what).toBe(
      "Matched otherwise it holds together.",
    );
    expect(offerWords(null, holds, 0.08).what).toBe("With a third parameter it holds together.");
  });

  it("does not say of a narrower gap that it holds", () => {
    const words = offerWords({ kind: "place", about: "" }, { holds: false, gap: 0.004 }, 0.046);
    expect(words.what).toBe("Another way breaks less: 0.4%, not 4.6%.");
    expect(offerWords(null, { holds: false, gap: 0.004 }, 0.046).what).not.toContain("holds");
  });
});

describe("triedWords", () => {
  const so = { done: 120, of: 120, problem: null, best: null };
  it("counts what was tried", () => {
    expect(triedWords(so)).toBe("120 other ways were tried: none of them holds, or breaks less.");
    expect(triedWords({ ...so, best: {} })).toBe("120 other ways were tried: none of them holds.");
    expect(triedWords({ ...so, done: 30 })).toContain("30 of 120");
    expect(triedWords({ ...so, done: 0, of: 0 })).toBe("No other way was tried.");
    expect(triedWords({ ...so, problem: "No memory." })).toContain("No memory.");
  });
});
