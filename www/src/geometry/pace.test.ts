import { describe, expect, it } from "vitest";
import { type Easing, heldFrames, momentsOf } from "./pace";

const EASINGS: readonly Easing[] = ["linear", "ease"];
const UNIT = { from: 0, to: 1 };
const rises = (list: readonly number[]) => list.every((moment, i) => i === 0 || moment >= (list[i - 1] ?? 0));

describe("moments of a film", () => {
  it("begin at the beginning, end at the end, and never go back before it", () => {
    for (const easing of EASINGS) {
      for (const held of [0, 4]) {
        for (const moving of [2, 3, 30, 31]) {
          const once = momentsOf({ from: 0.3, to: 7.1 }, moving, "once", { easing, held });
          expect([once.length, once[0], once.at(-1), rises(once)]).toEqual([
            moving + 2 * held,
            0.3,
            7.1,
            true,
          ]);
        }
      }
    }
  });

  it("are the same there and back, and show neither end twice", () => {
    for (const easing of EASINGS) {
      const round = momentsOf(UNIT, 60, "pingpong", { easing, held: 0 });
      expect(rises(round.slice(0, 31))).toBe(true);
      for (let i = 1; i < 30; i++) expect(round[60 - i]).toBe(round[i]);
      expect(round.filter((moment) => moment === 0)).toHaveLength(1);
      expect(round.filter((moment) => moment === 1)).toHaveLength(1);
      expect(new Set(round).size).toBe(31);
    }
  });

  it("start and stop gently where they ease, and go as fast at the half", () => {
    const [even, gentle] = EASINGS.map((easing) => momentsOf(UNIT, 101, "once", { easing, held: 0 }));
    const steps = (list: readonly number[] = []) => list.slice(1).map((moment, i) => moment - (list[i] ?? 0));
    expect(Math.max(...steps(even)) - Math.min(...steps(even))).toBeLessThan(1e-12);
    expect(steps(gentle)[0]).toBeLessThan(0.05 * (steps(gentle)[50] ?? 0));
    expect(gentle?.[50]).toBe(0.5);
    // The second half is the first, turned round.
    gentle?.forEach((moment, i) => {
      expect(moment).toBeCloseTo(1 - (gentle[100 - i] ?? 0), 12);
    });
  });

  it("stand still for exactly as many frames more as are asked for, at each end", () => {
    for (const easing of EASINGS) {
      for (const repeat of ["once", "pingpong"] as const) {
        const [bare, held] = [0, 7].map((frames) => momentsOf(UNIT, 24, repeat, { easing, held: frames }));
        for (const end of [0, 1]) {
          const at = (list: readonly number[] = []) => list.filter((moment) => moment === end).length;
          expect(at(held)).toBe(at(bare) + 7);
        }
        // In between nothing changes.
        const between = (list: readonly number[] = []) => list.filter((moment) => moment > 0 && moment < 1);
        expect(between(held)).toEqual(between(bare));
      }
    }
    const whole = momentsOf(UNIT, 4, "pingpong", { easing: "linear", held: 2 });
    expect(whole).toEqual([0, 0, 0, 0.5, 1, 1, 1, 0.5]);
  });

  it("go round evenly, and without a hold: there is no end", () => {
    expect(momentsOf(UNIT, 4, "round", { easing: "ease", held: 0 })).toEqual([0, 0.25, 0.5, 0.75]);
    expect([heldFrames(0.5, 30, "round"), heldFrames(0.5, 30, "once"), heldFrames(-1, 30, "once")]).toEqual([
      0, 15, 0,
    ]);
  });

  it("may be one alone", () => {
    expect(momentsOf({ from: 2, to: 3 }, 1, "once", { easing: "ease", held: 0 })).toEqual([2]);
    expect(momentsOf({ from: 2, to: 3 }, 1, "pingpong", { easing: "ease", held: 0 })).toEqual([2]);
  });
});
