import { describe, expect, it } from "vitest";
import { AT_REST } from "#document/deform/bend";
import {
  HOLDS,
  handleWords,
  holdWords,
  localityWords,
  momentWords,
  movedWords,
  roughnessWords,
} from "./deform-text";

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

describe("what is said of a handle", () => {
  it("counts from the left and from below", () => {
    const mesh = { columns: 4, rows: 4, box: [0, 0, 1, 1] as [number, number, number, number], moves: [] };
    expect(handleWords(mesh, 0)).toBe("Column 1, row 1: at rest");
    expect(handleWords({ ...mesh, moves: Array.from({ length: 32 }, (_, i) => i / 100) }, 9)).toBe(
      "Column 2, row 3: moved 0.18 right, 0.19 up",
    );
  });

  it("says the way, and what is small by its first figures", () => {
    expect(movedWords(-0.5, 0)).toBe("moved 0.5 left");
    expect(movedWords(0, -12.25)).toBe("moved 12.25 down");
    expect(movedWords(0.00123, 0)).toBe("moved 0.0012 right");
    expect(movedWords(0, 0)).toBe("at rest");
    expect(movedWords(Number.NaN, -0)).toBe("at rest");
  });
});
