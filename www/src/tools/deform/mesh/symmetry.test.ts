import { describe, expect, it } from "vitest";
import { partner, type Symmetry, spread } from "./symmetry";

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
