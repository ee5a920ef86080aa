import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { offerWords, triedWords } from "./way-words";

const holds = { holds: true, gap: 0 };

describe("offerWords", () => {
  it("says what a way would do before it says why", () => {
    const words = offerWords({ kind: "joints", about: "All joints stay joined." }, holds, 0.08, "Gasket");
    expect(words).toEqual({
      what: "Pairing joint by joint keeps the morph in one piece, up to rounding.",
      why: "All joints stay joined.",
    });
    expect(offerWords({ kind: "correspondence", about: "" }, holds, 0.08, "Gasket").what).toBe(
      "Pairing the maps differently keeps the morph in one piece.",
    );
    expect(offerWords(null, holds, 0.08, "Gasket").what).toBe(
      "A third parameter keeps the morph in one piece.",
    );
  });

  it("does not say of a narrower gap that it holds", () => {
    const words = offerWords({ kind: "place", about: "" }, { holds: false, gap: 0.004 }, 0.046, "Gasket");
    expect(words.what).toBe("Another path has a narrower gap: 0.4%, not 4.6%.");
    expect(offerWords(null, { holds: false, gap: 0.004 }, 0.046, "Gasket").what).not.toContain("one piece");
  });

  it("says of a shape that it would not stand as it was chosen", () => {
    const what = (kind: "place" | "mirror", turn: number, scale = 1) => {
      const [x, y] = [scale * Math.cos((turn * Math.PI) / 180), scale * Math.sin((turn * Math.PI) / 180)];
      const place: MapRow = [x, -y, y, x, 3, 4];
      return offerWords({ kind, about: "", place }, holds, 0.08, "Koch curve").what;
    };
    expect(what("place", -30)).toBe("Rotating Koch curve by 30° keeps the morph in one piece.");
    expect(what("place", -1)).toBe("Moving Koch curve keeps the morph in one piece.");
    expect(what("mirror", 180, 0.8)).toBe(
      "Morphing to the mirror image and rotating Koch curve by 180° keeps the morph in one piece.",
    );
    expect(what("mirror", 0, 2)).toBe("Morphing to the mirror image keeps the morph in one piece.");
  });
});

describe("triedWords", () => {
  const so = { done: 120, of: 120, problem: null, best: null };
  it("counts what was tried", () => {
    expect(triedWords(so)).toBe(
      "Frond tried 120 other paths: none stays in one piece or has a narrower gap.",
    );
    expect(triedWords({ ...so, best: {} })).toBe("Frond tried 120 other paths: none stays in one piece.");
    expect(triedWords({ ...so, done: 30 })).toContain("30 of 120");
    expect(triedWords({ ...so, done: 0, of: 0 })).toBe("Frond tried no other path.");
    expect(triedWords({ ...so, problem: "No memory." })).toContain("No memory.");
  });
});
