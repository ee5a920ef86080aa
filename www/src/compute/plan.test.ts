import { describe, expect, it } from "vitest";
import type { PathPlan } from "#wasm/api";
import { isBetter, leavesPlane, samePoints, wayOf } from "./plan";

const plan = (of: Partial<PathPlan>): PathPlan => ({
  points: [],
  gap: 0,
  holds: true,
  clearance: 0.1,
  ...of,
});

describe("paths through three parameters", () => {
  it("are kept short: six decimals, and no w where it is 0", () => {
    const points: PathPlan["points"] = [
      [0, 0],
      [1 / 3, 2 / 3, 0.1234567],
      [0.5, 0.5, 1e-9],
      [1, 1],
    ];
    expect(wayOf(plan({ points }))).toEqual([
      [0.333333, 0.666667, 0.123457],
      [0.5, 0.5],
    ]);
  });

  it("are told from those in the plane", () => {
    expect(
      leavesPlane([
        [0, 0],
        [0.5, 0.5, 0],
        [1, 1],
      ]),
    ).toBe(false);
    expect(leavesPlane([[0.5, 0.5, -0.1]])).toBe(true);
    expect(samePoints([[0.5, 0.5]], [[0.5, 0.5, 0]])).toBe(true);
    expect(samePoints([[0.5, 0.5]], [[0.5, 0.5, 0.1]])).toBe(false);
  });

  it("are taken where they hold, or break clearly less", () => {
    const broken = plan({ holds: false, gap: 0.1 });
    expect(isBetter(plan({}), broken)).toBe(true);
    expect(isBetter(plan({ clearance: 9 }), plan({}))).toBe(false);
    expect(isBetter(plan({ holds: false, gap: 0.05 }), broken)).toBe(true);
    expect(isBetter(plan({ holds: false, gap: 0.099 }), broken)).toBe(false);
  });
});
