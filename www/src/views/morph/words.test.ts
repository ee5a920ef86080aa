import { describe, expect, it } from "vitest";
import { gapWords, listWords, pathWords, verdictWords } from "./words";

describe("verdictWords", () => {
  it("never calls touching proved", () => {
    expect(verdictWords("touching")).toContain("at 600 px");
    expect(verdictWords("connected")).toBe("in one piece");
  });
});

describe("pathWords", () => {
  it("says that it holds", () => {
    expect(pathWords([], 0, 1)).toBe("In one piece all the way, at 600 px.");
    expect(pathWords([], null, 0.5)).toContain("so far");
    expect(pathWords([], null, 0)).toContain("Looking");
  });
  it("says where it breaks and how wide", () => {
    expect(pathWords([{ t0: 0.62, t1: 0.8 }], 0.03, 1)).toBe(
      "Breaks between 62% and 80%, widest gap 3% of its size.",
    );
    expect(pathWords([{ t0: 0.5, t1: 0.502 }], null, 1)).toBe("Breaks at 50%.");
  });
  it("joins what whole per cents cannot tell apart", () => {
    const near = [
      { t0: 0.19, t1: 0.198 },
      { t0: 0.202, t1: 1 },
    ];
    expect(pathWords(near, null, 1)).toBe("Breaks between 19% and 100%.");
  });
  it("counts where there are many", () => {
    const breaks = [0, 0.2, 0.4, 0.6, 0.8].map((t) => ({ t0: t, t1: t + 0.1 }));
    expect(pathWords(breaks, null, 1)).toBe(
      "Breaks between 0% and 10%, between 20% and 30% and in 3 more places.",
    );
  });
});

describe("gapWords", () => {
  it("has words for nothing and for next to nothing", () => {
    expect(gapWords(0)).toBe("no gap");
    expect(gapWords(Number.NaN)).toBe("no gap");
    expect(gapWords(1e-5)).toBe("under 0.1% of its size");
    expect(gapWords(0.0312)).toBe("3.1% of its size");
  });
});

describe("listWords", () => {
  it("joins with commas and an and", () => {
    expect(listWords([])).toBe("");
    expect(listWords(["A"])).toBe("A");
    expect(listWords(["A", "B", "C"])).toBe("A, B and C");
  });
});
