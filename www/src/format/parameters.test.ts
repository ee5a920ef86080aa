import { describe, expect, it } from "vitest";
import { complexWords, lowered, zoomWords } from "./parameters";

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
  it("writes complex numbers", () => {
    expect(complexWords([0.5, -0.25], 2)).toBe("0.50 − 0.25 i");
    expect(complexWords([-0.5, 0.7035], 3)).toBe("−0.500 + 0.704 i");
    expect(lowered(12)).toBe("₁₂");
  });
});
