import { describe, expect, it } from "vitest";
import {
  countWords,
  lengthWords,
  powerWords,
  resolutionWords,
  shareWords,
  stateOf,
  type Told,
  toldOf,
  verdictLine,
  verdictPhrase,
  verdictWords,
} from "./verdict";

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

describe("shareWords", () => {
  it.each([
    [0.003101, "0.32%"],
    [0.0031, "0.31%"],
    [0.25, "25%"],
    [1, "100%"],
    [0.0312, "3.2%"],
    [0.1, "10%"],
    [0.01, "1%"],
    [0.001, "0.1%"],
    [8e-6, "0.0008%"],
    [3e-9, "3 × 10⁻⁷%"],
    [3.11e-9, "3.2 × 10⁻⁷%"],
    [0, "0%"],
    [Number.NaN, ""],
    [Number.POSITIVE_INFINITY, ""],
  ])("says a gap of %d of the diameter as %s, never less than it is", (share, words) => {
    expect(shareWords(share)).toBe(words);
  });
});

describe("resolutionWords", () => {
  it("tells what counts as touching", () => {
    expect([1 / 600, 1 / 4800, 1 / 19200, 1e-14].map(resolutionWords)).toEqual([
      "1/600",
      "1/4800",
      "1/19 200",
      "10⁻¹⁴",
    ]);
    expect(powerWords(0)).toBe("0");
  });
});

describe("verdictWords", () => {
  const told = (verdict: Told["verdict"], upper = 0): Told => ({
    verdict,
    gap: { lower: 0, upper },
    diameter: 2,
  });

  it("has one wording for each of four verdicts, and one for no attractor", () => {
    expect(verdictLine(told("connected"))).toBe("In one piece, proved");
    expect(verdictLine(told("touching"))).toBe("No gap seen, checked to 1/600 of its size");
    expect(verdictLine(told("disconnected", 0.062))).toBe("In pieces, gap 3.1%, by Frond’s own bounds");
    expect(verdictWords(told("undecided")).text).toBe("Not decided");
    expect(verdictWords(told("no-attractor")).text).toBe("No attractor");
    expect(verdictWords(null).text).toBe("Checking …");
    expect(verdictPhrase(told("disconnected", 0.062))).toBe("in pieces, gap 3.1%, by Frond’s own bounds");
  });

  it("says that a shape is in pieces also where no pixel shows it", () => {
    expect(verdictWords(told("disconnected", 0.002))).toEqual({
      tone: "broken",
      text: "In pieces",
      aside: "gap 0.1%, under 1/600 of its size, by Frond’s own bounds",
    });
    expect(verdictLine(told("disconnected", 0.002), 1 / 4800)).toBe(
      "In pieces, gap 0.1%, by Frond’s own bounds",
    );
  });

  it("calls pieces proved only where a checker took the certificate", () => {
    expect(verdictLine(told("disconnected", 0.062))).not.toContain("proved");
    const checked = { ...told("disconnected", 0.062), checked: true };
    expect(verdictLine(checked)).toBe("In pieces, proved, gap 3.1%");
  });

  it("tells the resolution that it was looked at with", () => {
    expect(verdictLine(told("touching"), 1 / 4800)).toBe("No gap seen, checked to 1/4800 of its size");
  });

  it("calls nothing proved that is not, and counts no pieces", () => {
    for (const verdict of ["touching", "undecided", "no-attractor"] as const)
      expect(verdictLine(told(verdict, 0.5))).not.toMatch(/proved/);
    expect(verdictLine(told("disconnected", 0.5))).not.toMatch(/\d+ pieces/);
  });

  it("says the same of a sample of the map as of the answer that it stands for", () => {
    const states = [0, 1, 2, 3, 4, 5].map((state) => verdictPhrase(toldOf(state, 0.001)));
    expect(states).toEqual([
      "in one piece, proved",
      "no gap seen, checked to 1/600 of its size",
      "in pieces, gap 0.1%, under 1/600 of its size, by Frond’s own bounds",
      "not decided, deciding would take too long",
      "no attractor, the maps do not contract together",
      "in pieces, gap 0.1%, under 1/600 of its size, by Frond’s own bounds",
    ]);
    expect(toldOf(255, 0)).toBeNull();
    expect(verdictPhrase(toldOf(2, Math.fround(0.1)))).toBe("in pieces, gap 10%, by Frond’s own bounds");
    expect([0, 1, 3, 4].map((state) => stateOf(toldOf(state, 0) as Told))).toEqual([0, 1, 3, 4]);
    expect([0.001, 0.1].map((gap) => stateOf(toldOf(2, gap) as Told))).toEqual([5, 2]);
  });
});
