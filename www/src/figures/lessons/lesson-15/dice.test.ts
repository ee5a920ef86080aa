import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { byArea, chances, marksIn, play, shades, share, tally } from "./dice";
import { CUT } from "./shapes";

const MAPS = gasket(0.5);

describe("the game with uneven dice", () => {
  it("throws each map as often as its chance says, and is the same at every try", () => {
    const weights = [5, 3, 2];
    const game = play(MAPS, weights, 40_000);
    for (const [i, chance] of chances(weights).entries()) {
      expect(marksIn(game, [i]) / 40_000).toBeCloseTo(chance, 2);
    }
    expect(play(MAPS, weights, 40_000)).toEqual(game);
  });

  it("marks the piece of an address, whose first letter is the last throw", () => {
    const game = play(MAPS, [0.2, 0.5, 0.3], 20_000);
    let inside = 0;
    // Piece 2 of piece 1, f_1(f_2(A)): the lower triangle from 1/4 to 1/2.
    for (let i = 1; i < 20_000; i++) {
      const [x = 0, y = 0] = game.points.slice(2 * i, 2 * i + 2);
      if (x > 0.25 && x < 0.5 && y < HEIGHT / 4) inside++;
    }
    expect(Math.abs(marksIn(game, [0, 1]) - inside)).toBeLessThan(5);
    expect(inside / 20_000).toBeCloseTo(share([0.2, 0.5, 0.3], [0, 1]), 2);
  });

  it("never leaves the shape, and never throws what has no chance", () => {
    const game = play(MAPS, [1, 1, 0], 500);
    expect(marksIn(game, [2])).toBe(0);
    expect([...game.points].every((x) => x >= 0 && x <= 1)).toBe(true);
  });
});

it("goes by areas, with a little for what has none", () => {
  const stem: MapRow = [0, 0, 0, 0.2, 0, 0];
  const [none = 0, large = 0, small = 0] = byArea([stem, [0.8, 0, 0, 0.8, 0, 0], [0.4, 0, 0, -0.4, 0, 0]]);
  expect(none).toBeCloseTo(0.01 / 1.01, 12);
  expect(large / small).toBeCloseTo(4, 12);
});

describe("the cut triangle", () => {
  it("is shaded evenly by areas and by nothing else", () => {
    expect(byArea(CUT)[0]).toBeCloseTo(0.36, 12);
    const spread = (weights: readonly number[]) => {
      const cells = tally(play(CUT, weights, 60_000), {
        columns: 10,
        rows: 10,
        view: { x: 0.5, y: 0.24, scale: 10 },
      });
      // Cells that lie within the triangle.
      const within = [52, 53, 54, 55].map((at) => cells[at] ?? 0);
      return Math.max(...within) / Math.max(1, Math.min(...within));
    };
    expect(spread([0.36, 0.64])).toBeLessThan(1.2);
    expect(spread([0.5, 0.5])).toBeGreaterThan(1.5);
  });
});

it("counts marks by cells, with up on top, and shades what holds any", () => {
  const game = { points: Float64Array.of(0.1, 0.9, 0.9, 0.1, 0.8, 0.2, 5, 5), maps: new Uint8Array(4) };
  const cells = tally(game, { columns: 2, rows: 2, view: { x: 0.5, y: 0.5, scale: 2 } });
  expect([...cells]).toEqual([1, 0, 0, 2]);
  const [one = 0, none, , two = 0] = shades(cells);
  expect(none).toBe(0);
  expect(two).toBeGreaterThan(one);
  expect(one).toBeGreaterThan(0.3);
  expect([...shades(new Uint32Array(2))]).toEqual([0, 0]);
});
