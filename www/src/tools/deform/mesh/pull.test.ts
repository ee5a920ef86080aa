import { describe, expect, it } from "vitest";
import { weightsAt } from "#geometry/bezier";
import { pullMoves } from "./pull";
import { partner } from "./symmetry";

const FOUR = { columns: 4, rows: 4 };

function displaced(moves: readonly number[], u: number, v: number, mesh = FOUR): [number, number] {
  const weights = weightsAt(mesh, u, v);
  const along = (axis: 0 | 1) => weights.reduce((sum, w, i) => sum + w * (moves[2 * i + axis] ?? 0), 0);
  return [along(0), along(1)];
}

describe("pullMoves", () => {
  it("takes the place exactly along", () => {
    for (const [u, v] of [
      [0.5, 0.5],
      [0.1, 0.9],
      [0, 1],
      [1.3, 0.2],
    ] as const) {
      const [x, y] = displaced(pullMoves(FOUR, [u, v], [0.2, -0.7]), u, v);
      expect(x).toBeCloseTo(0.2, 12);
      expect(y).toBeCloseTo(-0.7, 12);
    }
  });

  it("moves a corner alone at the corner", () => {
    const moves = pullMoves(FOUR, [0, 0], [1, 2]);
    expect(moves.slice(0, 2)).toEqual([1, 2]);
    expect(moves.slice(2).every((x) => x === 0)).toBe(true);
  });

  it("moves as little as can be", () => {
    // Any other moves that take the place along are longer: here those of the nearest point alone.
    const moves = pullMoves(FOUR, [0.4, 0.4], [1, 0]);
    const least = moves.reduce((sum, x) => sum + x * x, 0);
    const weight = Math.max(...weightsAt(FOUR, 0.4, 0.4));
    expect(least).toBeLessThan((1 / weight) ** 2);
  });

  it("pulls both sides alike, and still takes the place along", () => {
    for (const by of ["sides", "levels", "point"] as const) {
      const moves = pullMoves(FOUR, [0.15, 0.2], [0.3, 0.4], by);
      const [x, y] = displaced(moves, 0.15, 0.2);
      expect(x).toBeCloseTo(0.3, 12);
      expect(y).toBeCloseTo(0.4, 12);
      for (let i = 0; i < 16; i++) {
        const other = partner(FOUR, i, by);
        expect(moves[2 * other]).toBeCloseTo((by === "levels" ? 1 : -1) * (moves[2 * i] ?? 0), 12);
        expect(moves[2 * other + 1]).toBeCloseTo((by === "sides" ? 1 : -1) * (moves[2 * i + 1] ?? 0), 12);
      }
    }
  });

  it("stays on the axis, and does not tear beside it", () => {
    const [x, y] = displaced(pullMoves(FOUR, [0.5, 0.3], [0.3, 0.4], "sides"), 0.5, 0.3);
    expect(x).toBeCloseTo(0, 12);
    expect(y).toBeCloseTo(0.4, 12);
    const beside = pullMoves(FOUR, [0.5 + 1e-6, 0.5], [1, 0], "sides");
    expect(Math.max(...beside.map(Math.abs))).toBeLessThan(1);
  });
});
