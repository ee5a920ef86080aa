import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { offerWords, triedWords, turnedWords } from "./way-words";

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

describe("turnedWords", () => {
  it("says of a shape that it does not stand as it was chosen", () => {
    const place = (turn: number, scale = 1) => {
      const [x, y] = [scale * Math.cos((turn * Math.PI) / 180), scale * Math.sin((turn * Math.PI) / 180)];
      return { place: [x, -y, y, x, 3, 4] as MapRow };
    };
    expect(turnedWords("Koch curve", place(180, 0.8))).toBe(" Koch curve is turned by 180° for it.");
    expect(turnedWords("Koch curve", place(-30))).toBe(" Koch curve is turned by 30° for it.");
    expect([place(0, 2), place(-1), {}].map((way) => turnedWords("Koch curve", way))).toEqual(["", "", ""]);
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
