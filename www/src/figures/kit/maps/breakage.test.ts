import { describe, expect, it } from "vitest";
import { STATE } from "#geometry/states";
import { breakage, shareWords, stretchWords } from "./breakage";

const [holds, broken, none, open] = [STATE.touching, STATE.disconnected, STATE.none, STATE.undecided];

describe("breakage", () => {
  it("counts the broken and those without a shape, and no others", () => {
    const found = breakage([holds, broken, open, holds, none, holds, holds, holds]);
    expect(found.share).toBe(0.25);
    expect(found.halves).toEqual([0.25, 0.25]);
    expect(found.stretches).toHaveLength(2);
    expect(breakage([holds, STATE.hidden]).share).toBe(0);
    expect(breakage([holds, STATE.hidden]).hidden).toBe(1);
  });
  it("leaves the middle of an odd number to neither half", () => {
    expect(breakage([holds, broken, broken]).halves).toEqual([0, 1]);
  });
  it("lives with nothing", () => {
    expect(breakage([])).toEqual({ stretches: [], share: 0, halves: [0, 0], hidden: 0 });
  });
});

describe("words", () => {
  it("never round to all or nothing", () => {
    expect([0, 0.001, 0.5, 0.999, 1].map(shareWords)).toEqual(["none", "1%", "50%", "99%", "all"]);
  });
  it("tell a few stretches and count the rest", () => {
    const some = [0.1, 0.3, 0.5].map((t0) => ({ t0, t1: t0 + 0.1 }));
    expect(stretchWords(some)).toBe("0.10 to 0.20, 0.30 to 0.40 and 0.50 to 0.60");
    expect(stretchWords(some, 1)).toBe("0.10 to 0.20 and 2 more");
    expect(stretchWords([])).toBe("");
    expect(stretchWords([{ t0: 0.9671, t1: 0.9689 }])).toBe("0.967 to 0.969");
  });
});
