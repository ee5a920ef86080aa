import { describe, expect, it } from "vitest";
import type { Connectedness } from "../../engine/api";
import {
  complexWords,
  epsilonWords,
  knownWords,
  lowered,
  partWords,
  powerWords,
  sampleWords,
  zoomWords,
} from "./words";

describe("numbers in words", () => {
  it("tells how near one is", () => {
    expect([1, 2.54, 33.8, 1400, 4.1e5, 1e13].map(zoomWords)).toEqual([
      "×1",
      "×2.5",
      "×34",
      "×1400",
      "× 4.1 × 10⁵",
      "× 10¹³",
    ]);
  });
  it("tells what counts as touching", () => {
    expect([1 / 600, 1 / 4800, 1 / 19200, 1e-14].map(epsilonWords)).toEqual([
      "1/600",
      "1/4800",
      "1/19 200",
      "10⁻¹⁴",
    ]);
  });
  it("tells gaps as parts of the shape", () => {
    expect([1, 0.1, 0.01, 0.001, 1e-4, 3e-9].map(partWords)).toEqual([
      "100%",
      "10%",
      "1%",
      "0.1%",
      "10⁻⁴",
      "3 × 10⁻⁹",
    ]);
  });
  it("writes complex numbers", () => {
    expect(complexWords([0.5, -0.25], 2)).toBe("0.50 − 0.25 i");
    expect(complexWords([-0.5, 0.7035], 3)).toBe("−0.500 + 0.704 i");
    expect(lowered(12)).toBe("₁₂");
    expect(powerWords(0)).toBe("0");
  });
});

describe("sampleWords", () => {
  it("names every state, and the gap of a break", () => {
    const words = [0, 1, 2, 3, 4, 255].map((state) => sampleWords(state, 0.02, 1 / 600));
    expect(new Set(words).size).toBe(6);
    expect(words[0]).toMatch(/proved/);
    expect(words[2]).toBe("broken, gap 2% of the shape");
  });
});

describe("knownWords", () => {
  const answer = (verdict: Connectedness["verdict"], upper = 0): Connectedness => ({
    verdict,
    gap: { lower: upper, upper },
    overlaps: [],
    components: [],
    count: 3,
    diameter: 2,
    nodes: 1,
  });
  it("says that it is proved only where it is", () => {
    expect(knownWords(answer("connected"), 1 / 600)).toBe("In one piece, proved");
    for (const verdict of ["touching", "disconnected", "undecided", "no-attractor"] as const)
      expect(knownWords(answer(verdict, 0.5), 1 / 600)).not.toMatch(/proved/);
  });
  it("tells the resolution it was looked at with", () => {
    expect(knownWords(answer("touching"), 1 / 4800)).toBe("In one piece, to 1/4800");
    expect(knownWords(answer("disconnected", 2 / 6000), 1 / 600)).toBe("In one piece, to 1/600");
    expect(knownWords(answer("disconnected", 0.5), 1 / 600)).toBe("3 pieces, gap 25% of its size");
  });
});
