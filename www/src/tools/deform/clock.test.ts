import { describe, expect, it } from "vitest";
import { advance } from "./clock";

describe("advance", () => {
  it("takes as long as it says", () => {
    expect(advance(0.25, 1, { seconds: 4, loop: false })).toEqual({ phase: 0.5, ended: false });
    expect(advance(0.75, 1, { seconds: 4, loop: false })).toEqual({ phase: 1, ended: true });
  });

  it("goes round and round", () => {
    const { phase, ended } = advance(0.9, 1, { seconds: 4, loop: true });
    expect(phase).toBeCloseTo(0.15, 12);
    expect(ended).toBe(false);
  });

  it("never leaves [0, 1], however long a step", () => {
    for (const loop of [true, false])
      for (const dt of [0, 1e-9, 7, 1e6]) {
        const { phase } = advance(0.3, dt, { seconds: 0.5, loop });
        expect(phase).toBeGreaterThanOrEqual(0);
        expect(phase).toBeLessThanOrEqual(1);
      }
  });
});
