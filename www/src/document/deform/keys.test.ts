import { describe, expect, it } from "vitest";
import type { Deformation, DeformKey } from "#wasm/api";
import { keyNear, MOST_KEYS, momentOf, withMoves } from "./keys";

const BASE: Deformation = {
  on: true,
  subject: "shape",
  parts: 2,
  columns: 2,
  rows: 2,
  box: [0, 0, 1, 1],
  keys: [],
  phase: 0,
  seconds: 4,
  loop: true,
  kb: 0,
  ke: 9,
  delta: 0.75,
  spin: "none",
  continuity: "auto",
  superposed: true,
};
const REST = new Array<number>(8).fill(0);
const MOVED = [1, 0, 0, 0, 0, 0, 0, 0];

function withKeys(moments: readonly number[], loop = true): Deformation {
  const keys: DeformKey[] = moments.map((at) => ({ at, moves: REST }));
  return { ...BASE, loop, keys };
}

describe("withMoves", () => {
  it("changes the only key at any moment", () => {
    const after = withMoves(withKeys([0]), 0.7, MOVED);
    expect(after.keys).toEqual([{ at: 0, moves: MOVED }]);
  });

  it("changes the key at the moment, and makes one between two", () => {
    const before = withKeys([0, 0.5]);
    expect(withMoves(before, 0.5004, MOVED).keys.map(({ at, moves }) => [at, moves[0]])).toEqual([
      [0, 0],
      [0.5, 1],
    ]);
    expect(withMoves(before, 0.25, MOVED).keys.map(({ at, moves }) => [at, moves[0]])).toEqual([
      [0, 0],
      [0.25, 1],
      [0.5, 0],
    ]);
    expect(before.keys).toHaveLength(2);
  });

  it("takes the end for the beginning where it loops, and for the end where not", () => {
    expect(withMoves(withKeys([0, 0.5]), 1, MOVED).keys.map(({ at }) => at)).toEqual([0, 0.5]);
    expect(withMoves(withKeys([0, 0.5]), 1, MOVED).keys[0]?.moves).toEqual(MOVED);
    expect(withMoves(withKeys([0.25, 0.5]), 0.9995, MOVED).keys.map(({ at }) => at)).toEqual([0, 0.25, 0.5]);
    expect(withMoves(withKeys([0, 0.5], false), 1, MOVED).keys.map(({ at }) => at)).toEqual([0, 0.5, 1]);
  });

  it("is the same deformation where nothing can change", () => {
    const full = withKeys(Array.from({ length: MOST_KEYS }, (_, i) => i / MOST_KEYS));
    expect(withMoves(full, 0.5 / MOST_KEYS, MOVED)).toBe(full);
    expect(withMoves(full, 1 / MOST_KEYS, MOVED)).not.toBe(full);
    const before = withKeys([0]);
    expect(withMoves(before, 0, [...REST])).toBe(before);
    expect(withMoves(before, 0, [Number.NaN, ...REST.slice(1)])).toBe(before);
    expect(withMoves(before, 0, [Number.POSITIVE_INFINITY, ...REST.slice(1)])).toBe(before);
    expect(withMoves(before, 0, [1])).toBe(before);
  });

  it("keeps keys in order and moments within the time line", () => {
    const after = withMoves(withMoves(withKeys([0.3, 0.6]), 2.1, MOVED), Number.NaN, MOVED);
    expect(after.keys.map(({ at }) => Math.round(100 * at) / 100)).toEqual([0, 0.1, 0.3, 0.6]);
    expect(momentOf({ loop: false }, 7)).toBe(1);
    expect(momentOf({ loop: false }, -7)).toBe(0);
  });
});

describe("keyNear", () => {
  it("is the nearest of two that are near", () => {
    const keys = withKeys([0.5, 0.501]);
    expect(keyNear(keys, 0.5007)).toBe(1);
    expect(keyNear(keys, 0.5002)).toBe(0);
    expect(keyNear(keys, 0.4)).toBe(-1);
    expect(keyNear(withKeys([]), 0.4)).toBe(-1);
  });

  it("looks across the end where it loops", () => {
    expect(keyNear(withKeys([0.4, 0.9996]), 0.0003)).toBe(1);
    expect(keyNear(withKeys([0.4, 0.9996], false), 0.0003)).toBe(-1);
  });
});
