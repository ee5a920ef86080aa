import { describe, expect, it } from "vitest";
import {
  bestWords,
  certifiedWords,
  gapWords,
  listWords,
  matchWords,
  meritWords,
  pathWords,
  roomWords,
  shareWords,
  verdictWords,
} from "./morph-words";

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

describe("what is proved of a path", () => {
  const so = { done: 48, parts: 48, gap: 0.0031, boxes: 4212, worst: 0.634, problem: null };

  it("gives the bound, the boxes and the place where it is weakest", () => {
    expect(certifiedWords(so)).toBe(
      "No gap wider than 0.31% of the shape anywhere on this path: proved with 4,212 boxes. The bound is weakest at 63%.",
    );
    expect(certifiedWords({ ...so, gap: 0 })).toBe(
      "In one piece everywhere on this path: proved with 4,212 boxes.",
    );
  });

  it("claims nothing before the end, nor without a bound", () => {
    expect(certifiedWords({ ...so, done: 12 })).toBe("Proving it: 25% of the path.");
    expect(certifiedWords({ ...so, gap: Number.POSITIVE_INFINITY })).toMatch(/^No bound could be proved/);
    expect(certifiedWords({ ...so, problem: "The path is too long." })).toBe(
      "It could not be proved. The path is too long.",
    );
  });

  it("rounds a bound up, never down", () => {
    expect(shareWords(0.003101)).toBe("0.32%");
    expect(shareWords(0.0031)).toBe("0.31%");
    expect(shareWords(0.25)).toBe("25%");
    expect(shareWords(0)).toBe("0%");
    expect(shareWords(1e-9)).toBe("0.000001%");
  });
});

describe("room and best", () => {
  it("tells how near a path comes to breaking", () => {
    expect(roomWords(0.0834)).toBe("It keeps 0.08 away from what breaks.");
    expect(roomWords(0.001)).toBe("It runs along the very edge of what holds.");
    expect(roomWords(Number.POSITIVE_INFINITY)).toBe("");
    expect(roomWords(undefined)).toBe("");
  });

  it("says how sure it is that no path holds", () => {
    expect(bestWords(false, false)).toBe(
      "No path on this square was found to hold all the way: this one breaks least.",
    );
    expect(bestWords(true, true)).toMatch(/^Even with the third parameter no path can hold/);
  });
});

describe("ways to match", () => {
  it("are told in words while they are few", () => {
    expect(matchWords([0, 1, 2], [0, 0, 0])).toBe("each keeps its number");
    expect(matchWords([1, 0, 2], [])).toBe("1 becomes 2 and 2 becomes 1");
    expect(matchWords([1, 2, 3, 4, 0], [0, 1, 0, 0, 0])).toBe(
      "5 of 5 maps change partner; one turns further",
    );
  });

  it("are told by the best path that they allow", () => {
    expect(meritWords({ holds: true, gap: 0 })).toBe("holds all the way");
    expect(meritWords({ holds: false, gap: 0.012 })).toBe("gap 1.2%");
    expect(meritWords({ holds: false, gap: Number.POSITIVE_INFINITY })).toBe("meets no shape on the way");
  });
});
