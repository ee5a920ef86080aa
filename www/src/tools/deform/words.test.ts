import { describe, expect, it } from "vitest";
import { AT_REST } from "#document/deform/bend";
import { momentWords } from "./strip/words";
import { HOLDS, holdWords, localityWords, roughnessWords } from "./words";

describe("words of the sliders", () => {
  it("say where it turns rough, and where it is plain", () => {
    expect(roughnessWords(0.4, 0.5)).toBe("0.4, smooth");
    expect(roughnessWords(0.5, 0.5)).toBe("0.5, rough");
    expect(roughnessWords(0, 0.5)).toContain("only the largest");
    expect(localityWords(9, 9)).toBe("9 of 9, plain");
    expect(localityWords(0, 9)).toContain("scattered");
    expect(localityWords(2.5, 9)).toBe("2.5 of 9");
  });
});

describe("holdWords", () => {
  it("says what automatic came to, and what could not be had", () => {
    expect(holdWords("auto", "splat")).toBe("automatic: smoothing");
    // Only what the paper does is called published: `average` leaves some terms exact.
    expect(HOLDS.filter(({ label }) => label.includes("published")).map(({ value }) => value)).toEqual([
      "published",
    ]);
    expect(holdWords("average", "average")).toBe("averages with the smooth terms exact");
    expect(holdWords("auto", null)).toBe("automatic");
    expect(holdWords("corners", "corners")).toBe("shared corners");
    expect(holdWords("corners", "raw")).toBe("none (not available here: shared corners)");
  });
});

it("says whether there is a key at the moment", () => {
  const keys = [0, 0.5].map((at) => ({ at, moves: [] }));
  expect(momentWords({ ...AT_REST, keys, phase: 0.5 })).toBe("50%, keyframe 2 of 2");
  expect(momentWords({ ...AT_REST, keys, phase: 0.3 })).toBe("30%, between keyframes");
  expect(momentWords(AT_REST)).toBe("0%, nothing moves");
});
