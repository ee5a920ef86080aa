import { describe, expect, it } from "vitest";
import type { DeformKey } from "#wasm/api";
import { AT_REST, bendAt, movesAt } from "./bend";

const key = (at: number, ...moves: number[]): DeformKey => ({ at, moves });

describe("the mesh between its keys", () => {
  it("is the key alone where there is one", () => {
    for (const phase of [0, 0.3, 1]) expect(movesAt([key(0.5, 1, 2)], phase, true)).toEqual([1, 2]);
    expect(movesAt([], 0.5, true)).toEqual([]);
  });

  it("passes through every key", () => {
    const keys = [key(0.1, 0, 5), key(0.4, 1, 4), key(0.5, -2, 3), key(0.9, 3, 3)];
    for (const loop of [true, false]) {
      for (const { at, moves } of keys) {
        movesAt(keys, at, loop).forEach((x, i) => {
          expect(x).toBeCloseTo(moves[i] ?? Number.NaN, 12);
        });
      }
    }
  });

  it("holds the ends where it does not loop", () => {
    const keys = [key(0.2, 1), key(0.6, 3)];
    expect(movesAt(keys, 0, false)).toEqual([1]);
    expect(movesAt(keys, 0.95, false)).toEqual([3]);
  });

  it("goes on from the last key to the first where it loops, without a jump", () => {
    const keys = [key(0, 0), key(0.25, 1), key(0.5, 0), key(0.75, -1)];
    expect(movesAt(keys, 0.9999, true)[0]).toBeCloseTo(movesAt(keys, 0, true)[0] ?? 9, 2);
    const late = [key(0.3, 2), key(0.6, 4)];
    // Half way from 0.6 round to 1.3 is 0.95.
    expect(movesAt(late, 0.95, true)[0]).toBeCloseTo(3, 12);
    expect(movesAt(late, 0, true)[0]).toBeCloseTo(movesAt(late, 1, true)[0] ?? 9, 12);
  });

  it("does not overshoot where it turns back", () => {
    const keys = [key(0, 0), key(0.25, 1), key(0.5, 1), key(0.75, 0)];
    for (let i = 0; i <= 200; i++) {
      const [x = 9] = movesAt(keys, i / 200, true);
      expect(x).toBeGreaterThanOrEqual(-1e-12);
      expect(x).toBeLessThanOrEqual(1 + 1e-12);
    }
  });

  it("is smooth at a key that it goes through", () => {
    const keys = [key(0, 0), key(0.25, 1), key(0.5, 3), key(0.75, 4)];
    const at = (phase: number) => movesAt(keys, phase, false)[0] ?? Number.NaN;
    const before = (at(0.25) - at(0.25 - 1e-6)) / 1e-6;
    const after = (at(0.25 + 1e-6) - at(0.25)) / 1e-6;
    expect(after).toBeCloseTo(before, 3);
    expect(after).toBeGreaterThan(1);
  });
});

describe("a bend", () => {
  it("has what the renderer needs, and nothing of the time line", () => {
    const bend = bendAt({ ...AT_REST, kb: 1.5 }, 0.25);
    expect(bend.kb).toBe(1.5);
    expect(bend.moves).toHaveLength(32);
    expect(Object.keys(bend)).not.toContain("keys");
    expect("tint" in bend).toBe(false);
  });
});
