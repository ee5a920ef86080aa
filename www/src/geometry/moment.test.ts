import { describe, expect, it } from "vitest";
import { advance, SECONDS } from "./moment";

describe("advance", () => {
  it("takes as long as it says", () => {
    expect(advance(0, SECONDS / 2, 1, { speed: 1, loop: false }).t).toBeCloseTo(0.5, 12);
    expect(advance(0, SECONDS / 2, 1, { speed: 2, loop: false })).toMatchObject({ t: 1, ended: true });
  });

  it("turns round at both ends", () => {
    expect(advance(0.9, 0.2 * SECONDS, 1, { speed: 1, loop: true })).toMatchObject({ way: -1, ended: false });
    const back = advance(0.1, 0.2 * SECONDS, -1, { speed: 1, loop: true });
    expect(back.t).toBeCloseTo(0.1, 12);
    expect(back.way).toBe(1);
  });

  it("never leaves [0, 1], however long a step", () => {
    for (const dt of [0, 1e-9, 7, 1e6]) {
      const { t } = advance(0.3, dt, 1, { speed: 4, loop: true });
      expect(t).toBeGreaterThanOrEqual(0);
      expect(t).toBeLessThanOrEqual(1);
    }
  });
});
