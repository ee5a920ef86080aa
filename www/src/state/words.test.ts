import { describe, expect, it } from "vitest";
import type { Connectedness } from "../engine/api";
import { countWords, lengthWords, verdictWords } from "./words";

describe("lengthWords", () => {
  it.each([
    [0, "0"],
    [0.0213, "0.021"],
    [1.449, "1.4"],
    [37.2, "37"],
    [2.14e-6, "2.1e-6"],
    [Number.NaN, ""],
  ])("says %d as %s", (length, words) => {
    expect(lengthWords(length)).toBe(words);
  });
});

describe("countWords", () => {
  it.each([
    [0, "0"],
    [950, "950"],
    [12_400, "12 k"],
    [1_040_000, "1.0 M"],
    [20_000_000, "20 M"],
  ])("says %d as %s", (count, words) => {
    expect(countWords(count)).toBe(words);
  });
});

describe("verdictWords", () => {
  const answer: Connectedness = {
    verdict: "disconnected",
    gap: { lower: 0.019, upper: 0.02 },
    overlaps: [],
    components: [0, 1, 2],
    count: 3,
    diameter: 1,
    nodes: 1,
  };

  it("counts the pieces and measures the gap", () => {
    expect(verdictWords(answer)).toMatchObject({
      tone: "broken",
      text: "3 pieces",
      aside: "widest gap 0.020",
    });
  });

  it("says that a gap finer than the resolution is one", () => {
    const fine = verdictWords({ ...answer, gap: { lower: 0.0007, upper: 0.0008 } });
    expect(fine).toMatchObject({ tone: "close", aside: "at 600 px, gap 0.00080" });
  });

  it("never calls touching proved", () => {
    const { text, aside } = verdictWords({ ...answer, verdict: "touching", count: 1 });
    expect(`${text} ${aside}`).toBe("In one piece at 600 px");
  });
});
