import { beforeAll, describe, expect, it } from "vitest";
import * as frond from "../../www/pkg/index.js";
import { load, refused, wrong } from "./frond";

beforeAll(load);

const gasket: frond.Ifs = {
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0, 0.5],
  ],
};

/** A mesh of four by four over the unit square whose points all move by the same, with some fields changed. */
const bend = (dx: number, dy: number, change: object = {}) =>
  wrong({
    columns: 4,
    rows: 4,
    box: [0, 0, 1, 1],
    moves: Array.from({ length: 16 }, () => [dx, dy]).flat(),
    kb: 0,
    ke: 6,
    delta: 0.75,
    spin: "none",
    continuity: "auto",
    superposed: true,
    ...change,
  });

describe("a fractal deformation", () => {
  it("reverses a block of letters", () => {
    const shuffled = (kb: number, ke: number) => Array.from(frond.shuffle(5, kb, ke, [2, 4, 1, 0, 1]));
    expect(shuffled(1, 4)).toEqual([2, 0, 1, 4, 1]);
    expect(shuffled(3, 3)).toEqual([2, 4, 1, 0, 1]);
    for (const [symbols, kb, ke, letters] of [
      [0, 0, 1, [0]],
      [2, 0, 2, [0]],
      [2, 1, 0, [0, 1]],
      [2, 0.5, 1, [0, 1]],
      [2, 0, 1, [0, 2]],
      [Number.NaN, Number.NaN, Number.NaN, [Number.NaN]],
      [1e9, 0, 1, [0]],
    ] as const)
      expect(refused(() => frond.shuffle(symbols, kb, ke, [...letters]))).toBe("bad-input");
  });

  it("moves all points as its mesh, where that moves as one", () => {
    const codes = [[0, 1, 2, 0, 1, 2], [2, 2, 2, 2, 2, 2], []];
    const tails: [number, number][] = [
      [0.25, 0.25],
      [0, 1],
      [0.5, 0],
    ];
    const moved = frond.deform(gasket, bend(0.25, -0.5), codes, tails);
    const rest = frond.deform(gasket, bend(0, 0), codes, tails);
    expect(moved).toHaveLength(6);
    for (const [i, x] of moved.entries())
      expect(x - (rest[i] ?? Number.NaN)).toBeCloseTo(i % 2 === 0 ? 0.25 : -0.5, 12);
    const grid = frond.meshGrid(bend(0.25, -0.5), 11);
    expect(grid).toHaveLength(242);
    expect(grid[0]).toBeCloseTo(0.25, 12);
    expect(grid[241]).toBeCloseTo(0.5, 12);
  });

  it("draws the same, whatever was drawn before", () => {
    const lifted = (by: number) =>
      bend(0, 0, { moves: Array.from({ length: 32 }, (_, i) => (i === 13 ? by : 0)) });
    const draw = (by: number) => frond.rasterize(gasket, { width: 90, height: 60, bend: lifted(by) });
    const [first, moved] = [draw(0.1), draw(0.6)];
    // Another shape in between: nothing is left of the one before.
    frond.bendFacts({ maps: gasket.maps.slice(0, 2) }, lifted(0.2));
    expect(draw(0.6)).toEqual(moved);
    expect(draw(0.1)).toEqual(first);
    expect(moved).not.toEqual(first);
  });

  it("bends a density as it bends the colours of pieces", () => {
    const size = { width: 90, height: 60, view: { x: 0.5, y: 0.5, scale: 30 } };
    const lit = (options: Partial<frond.RasterOptions>) => {
      const pixels = frond.rasterize(gasket, { ...size, ...options });
      return Array.from({ length: 90 * 60 }, (_, i) => (pixels[4 * i + 3] ?? 0) > 0);
    };
    const moved = bend(0.4, -0.3);
    for (const draft of [false, true]) {
      const [coloured, dense] = [
        lit({ bend: moved, draft }),
        lit({ bend: moved, draft, colouring: "density" }),
      ];
      // A draft shares masses with the pixels beside them.
      const near = dense.filter((on, i) => on && [0, 1, -1, 90, -90].some((by) => coloured[i + by])).length;
      expect(near / dense.filter(Boolean).length).toBeGreaterThan(0.97);
      expect(dense).not.toEqual(lit({ draft, colouring: "density" }));
    }
  });

  it("tells what came of it", () => {
    const facts = frond.bendFacts(gasket, bend(0.3, 0.4));
    expect(facts).toMatchObject({ continuity: "corners", ke: 6 });
    expect(facts.deepest).toBeGreaterThanOrEqual(12);
    expect(facts.reach).toBeGreaterThanOrEqual(0.5 - 1e-12);
    for (const continuity of ["average", "published"])
      expect(frond.bendFacts(gasket, bend(0.3, 0.4, { continuity })).continuity).toBe(continuity);
  });

  it.each([
    { kb: 7 },
    { kb: -1 },
    { delta: -1 },
    { delta: null },
    { delta: [0.5, 0.5] },
    { columns: 1 },
    { columns: 1_000_000, rows: 1_000_000 },
    { moves: [0, 0] },
    { box: [0, 0, 0, 1] },
    { spin: "fast" },
    { continuity: "glue" },
    { tint: { colours: ["red"], kb: 0, ke: 1, delta: 1, superposed: true } },
    { tint: { colours: ["#ff0000"], kb: 0, ke: 1, delta: 1, superposed: true } },
  ])("says why %o cannot be bent", (change) => {
    expect(refused(() => frond.bendFacts(gasket, bend(0, 0, change)))).not.toBe("");
  });

  it("says that its mesh has no numbers", () => {
    expect(refused(() => frond.bendFacts(gasket, bend(Number.MAX_VALUE, 0)))).toBe("mesh-numbers");
  });
});

describe("a photograph", () => {
  /** Its colours tell the place, and a corner can be seen through. */
  const bytes = (width: number, height: number) =>
    Uint8Array.from(
      Array.from({ length: width * height }, (_, i) => {
        const [x, y] = [i % width, Math.floor(i / width)];
        const blue = (Math.floor(x / 5) + Math.floor(y / 5)) % 2 === 0 ? 40 : 190;
        return [(x * 255) / width, (y * 255) / height, blue, x + y < 20 ? 90 : 255];
      }).flat(),
    );
  const rgba = bytes(30, 20);
  const bent = (moves: number[]) =>
    wrong({
      columns: 2,
      rows: 2,
      box: [0, 0, 1.5, 1],
      moves,
      kb: 1,
      ke: 4,
      delta: 0.5,
      spin: "none",
      continuity: "auto",
      superposed: true,
    });
  const size = { width: 60, height: 40 };
  const still = bent([0, 0, 0, 0, 0, 0, 0, 0]);

  it("is bent, and what cannot be drawn is refused", () => {
    const sheet = new frond.Sheet(rgba, 30, 20);
    const rest = Array.from(sheet.draw(null, 2, size));
    expect(rest).toHaveLength(60 * 40 * 4);
    const unmoved = sheet.draw(still, 2, size);
    const mean =
      rest.reduce((sum, byte, i) => sum + Math.abs(byte - (unmoved[i] ?? Number.NaN)), 0) / rest.length;
    expect(mean).toBeLessThan(1);
    const moves = [0, 0, 0.3, 0, 0, 0, 0, 0.4];
    const moved = Array.from(sheet.draw(bent(moves), 2, size));
    const other = (i: number) =>
      [0, 1, 2, 3].some((k) => Math.abs((rest[4 * i + k] ?? 0) - (moved[4 * i + k] ?? 0)) > 40);
    const others = Array.from({ length: 60 * 40 }, (_, i) => i).filter(other).length;
    expect(others / (60 * 40)).toBeGreaterThan(0.1);
    // As if it had been made anew.
    expect(Array.from(new frond.Sheet(rgba, 30, 20).draw(bent(moves), 2, size))).toEqual(moved);
    expect(refused(() => sheet.draw(bent([0, 0]), 2, size))).toBe("mesh-count");
    expect(refused(() => sheet.draw(still, 5, size))).toBe("bad-input");
    expect(refused(() => sheet.draw(null, 2, { width: 60_000, height: 40 }))).toBe("picture-too-large");
    for (const [picture, width, height, code] of [
      [rgba, 31, 20, "photo-bytes"],
      [rgba, Number.NaN, 20, "photo-size"],
      [rgba, 10_000, 10_000, "photo-size"],
      ["picture", 30, 20, "bad-input"],
    ] as const)
      expect(refused(() => new frond.Sheet(wrong(picture), width, height))).toBe(code);
    // And it still draws.
    expect(Array.from(sheet.draw(null, 2, size))).toEqual(rest);
  });
});
