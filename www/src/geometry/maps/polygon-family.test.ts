import { describe, expect, it } from "vitest";
import type { Connectedness } from "#wasm/api";
import { answerOf, fills } from "./polygon-family";

const found = (verdict: Connectedness["verdict"]): Connectedness => ({
  verdict,
  gap: { lower: 0, upper: 0.001 },
  overlaps: [[0, 1]],
  components: [0, 0, 1],
  count: 2,
  closest: { from: [0, 0], to: [0, 0.001] },
  diameter: 1,
  nodes: 1,
});

describe("polygon families", () => {
  it("must be in one piece where n |s|² is 1 or more and n is prime", () => {
    expect(fills(3, [0.5, 0.5])).toBe(true);
    expect(fills(3, [0.45, 0.45])).toBe(true);
    expect(fills(3, [0.4, 0.4])).toBe(false);
    // Of four, one and three may meet, and two and four, and the pairs lie apart.
    expect(fills(4, [0.6, 0])).toBe(false);
    expect(fills(7, [0, 0.378])).toBe(true);
    expect(fills(7, [0, 0.377])).toBe(false);
  });

  it("have the answer of the theorem where a search only finds no gap, and none where there is no attractor", () => {
    const answer = answerOf(found("touching"), 3, [0.45, 0.45]);
    expect(answer).toMatchObject({
      verdict: "connected",
      gap: { upper: 0 },
      components: [0, 0, 0],
      count: 1,
    });
    expect(answer.closest).toBeUndefined();
    expect(answer.reason?.text).toContain("3 is prime");
    expect(answerOf(found("touching"), 4, [0.6, 0]).verdict).toBe("touching");
    expect(answerOf(found("no-attractor"), 3, [1, 1]).verdict).toBe("no-attractor");
  });
});
