import { describe, expect, it } from "vitest";
import { weightsAt } from "#geometry/bezier";
import { partner, pullMoves, type Symmetry, spread } from "./edit";

const FOUR = { columns: 4, rows: 4 };
const THREE = { columns: 3, rows: 3 };
const moved = (mesh: typeof FOUR, chosen: number[], held: number, by: Symmetry) =>
  [...spread(mesh, chosen, held, [0.5, 0.25], by)].sort(([p], [q]) => p - q);

describe("partner", () => {
  it("mirrors columns, rows, or both", () => {
    expect(partner(FOUR, 1, "sides")).toBe(2);
    expect(partner(FOUR, 1, "levels")).toBe(13);
    expect(partner(FOUR, 1, "point")).toBe(14);
    expect(partner(FOUR, 1, "off")).toBe(1);
    expect(partner({ columns: 2, rows: 3 }, 4, "sides")).toBe(5);
  });

  it("is its own inverse", () => {
    for (const by of ["sides", "levels", "point"] as const)
      for (let i = 0; i < 12; i++) {
        const mesh = { columns: 3, rows: 4 };
        expect(partner(mesh, partner(mesh, i, by), by)).toBe(i);
      }
  });
});

describe("spread", () => {
  it("moves what is chosen, alone", () => {
    expect(moved(FOUR, [5, 2], 5, "off")).toEqual([
      [2, [0.5, 0.25]],
      [5, [0.5, 0.25]],
    ]);
  });

  it("answers on the other side", () => {
    expect(moved(FOUR, [4], 4, "sides")).toEqual([
      [4, [0.5, 0.25]],
      [7, [-0.5, 0.25]],
    ]);
    expect(moved(FOUR, [4], 4, "levels")).toEqual([
      [4, [0.5, 0.25]],
      [8, [0.5, -0.25]],
    ]);
    expect(moved(FOUR, [4], 4, "point")).toEqual([
      [4, [0.5, 0.25]],
      [11, [-0.5, -0.25]],
    ]);
  });

  it("lets the side that is held lead where both are chosen", () => {
    expect(moved(FOUR, [0, 3], 3, "sides")).toEqual([
      [0, [-0.5, 0.25]],
      [3, [0.5, 0.25]],
    ]);
    // Whole rows of both sides, held at the left.
    const rows = moved(FOUR, [0, 1, 2, 3, 4, 5, 6, 7], 4, "sides");
    expect(rows.map(([, [dx]]) => dx)).toEqual([0.5, 0.5, -0.5, -0.5, 0.5, 0.5, -0.5, -0.5]);
  });

  it("keeps what lies on the axis there", () => {
    expect(moved(THREE, [1], 1, "sides")).toEqual([[1, [0, 0.25]]]);
    expect(moved(THREE, [3], 3, "levels")).toEqual([[3, [0.5, 0]]]);
    expect(moved(THREE, [4], 4, "point")).toEqual([[4, [0, 0]]]);
  });
});

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
