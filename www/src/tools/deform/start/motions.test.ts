import { describe, expect, it } from "vitest";
import { AT_REST, movesAt } from "#document/deform/bend";
import type { Deformation } from "#wasm/api";
import { MOTIONS, motionOf, poseOf, rounder, withMotion } from "./motions";

const rest: Deformation = { ...AT_REST, box: [-1, 0, 3, 8] };
const moving = MOTIONS.filter(({ id }) => id !== "still");
const point = (moves: readonly number[], column: number, row: number, columns = 4) =>
  moves.slice(2 * (row * columns + column), 2 * (row * columns + column) + 2);

describe("withMotion", () => {
  it.each(moving)("$name moves around the pose it finds, and comes back to it", ({ id }) => {
    const pose = rest.keys[0]?.moves.map((_, i) => (i % 5) / 10) ?? [];
    const made = withMotion({ ...rest, keys: [{ at: 0, moves: pose }], phase: 0.4 }, id);
    expect(made.phase).toBe(0);
    expect(made.loop).toBe(true);
    expect(made.keys.length).toBeGreaterThan(1);
    expect(made.keys.every(({ at }, i) => at < 1 && at >= 0 && at > (made.keys[i - 1]?.at ?? -1))).toBe(true);
    poseOf(made).forEach((x, i) => {
      expect(x).toBeCloseTo(pose[i] ?? 0, 4);
    });
    expect(movesAt(made.keys, 0.25, true)).not.toEqual(movesAt(made.keys, 0.75, true));
  });

  it.each(moving)("$name is known again, also after another one", ({ id }) => {
    for (const before of moving) {
      const made = withMotion(withMotion(rest, before.id), id);
      expect(motionOf(made)).toBe(id);
      expect(motionOf({ ...made, phase: 0.3, seconds: 9 })).toBe(id);
    }
    const made = withMotion(rest, id);
    const [first, ...others] = made.keys;
    const changed = { at: 0, moves: first?.moves.map((x, i) => (i === 7 ? x + 1 : x)) ?? [] };
    expect(motionOf({ ...made, keys: [changed, ...others] })).toBeNull();
  });

  it("sways the top and leaves the foot, and turns with the pieces", () => {
    const made = withMotion(rest, "sway");
    expect(made.spin).toBe("scaled");
    const [right, left] = [made.keys[1]?.moves ?? [], made.keys[3]?.moves ?? []];
    for (let column = 0; column < 4; column++) {
      expect(point(right, column, 0)).toEqual([0, 0]);
      expect(point(right, column, 3)[0]).toBeGreaterThan(0.5);
      expect(point(left, column, 3)[0]).toBeLessThan(-0.5);
    }
  });

  it("breathes out from the middle, and in", () => {
    const { keys } = withMotion(rest, "breathe");
    const [out, back] = [keys[1]?.moves ?? [], keys[3]?.moves ?? []];
    expect(point(out, 0, 0).every((x) => x < 0)).toBe(true);
    expect(point(out, 3, 3).every((x) => x > 0)).toBe(true);
    expect(point(back, 3, 3).every((x) => x < 0)).toBe(true);
  });

  it("pulls one corner and no other", () => {
    const { keys } = withMotion(rest, "corner");
    const moves = keys[1]?.moves ?? [];
    expect(point(moves, 3, 3)[0]).toBeGreaterThan(1);
    for (const [column, row] of [
      [0, 0],
      [3, 0],
      [0, 3],
    ] as const)
      expect(point(moves, column, row)).toEqual([0, 0]);
  });

  it("stands still as it is at the moment", () => {
    const made = withMotion({ ...withMotion(rest, "sway"), phase: 0.25 }, "still");
    expect(made.keys).toHaveLength(1);
    expect(made.keys[0]?.moves).toEqual(withMotion(rest, "sway").keys[1]?.moves);
    expect(motionOf(made)).toBe("still");
    expect(withMotion(made, "still")).toBe(made);
  });

  it("fits meshes of two by two and of sixteen", () => {
    for (const [columns, rows] of [
      [2, 2],
      [16, 3],
    ] as const) {
      const mesh = {
        ...rest,
        columns,
        rows,
        keys: [{ at: 0, moves: new Array(2 * columns * rows).fill(0) }],
      };
      for (const { id } of moving) {
        const { keys } = withMotion(mesh, id);
        for (const { moves } of keys) {
          expect(moves).toHaveLength(2 * columns * rows);
          expect(moves.every(Number.isFinite)).toBe(true);
        }
      }
    }
  });
});

describe("rounder", () => {
  it("keeps five figures of a size, and is never minus nothing", () => {
    expect(rounder(1)(0.123456789)).toBe(0.12346);
    expect(rounder(1000)(1.23456)).toBe(1.23);
    expect(Object.is(rounder(1)(-1e-9), 0)).toBe(true);
    expect(rounder(0)(0.5)).toBe(0.5);
  });
});
