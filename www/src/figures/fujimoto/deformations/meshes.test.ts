import { expect, it } from "vitest";
import { DRAGON_COLOURS, DRAW, LIFT, movesOf, plainShade, SWAY, shade, thirds } from "./meshes";

const moveAt = (mesh: { moves: readonly number[] }, i: number, j: number) => [
  mesh.moves[2 * (4 * j + i)],
  mesh.moves[2 * (4 * j + i) + 1],
];

it("has one move for each of 4 x 4 control points", () => {
  for (const mesh of [LIFT, SWAY, DRAW]) {
    expect(mesh.moves).toHaveLength(32);
    expect(mesh.moves.every(Number.isFinite)).toBe(true);
  }
});

it("does what the paper says of each", () => {
  // The rim of the square stays, so the legs of the gasket do; the lift is towards the upper right.
  for (const i of [0, 1, 2, 3]) expect(moveAt(LIFT, i, 0)).toEqual([0, 0]);
  expect(moveAt(LIFT, 2, 2)).toEqual([0.364, 0.364]);
  // The foot of the fern stays, its tip goes to a side.
  expect(moveAt(SWAY, 1, 0)).toEqual([0, 0]);
  expect(moveAt(SWAY, 0, 3)).toEqual([2.2, -0.55]);
  // The dragon is drawn at its lower right alone.
  expect(moveAt(DRAW, 3, 0)).toEqual([0.85, -0.68]);
  expect(moveAt(DRAW, 0, 3)).toEqual([0, 0]);
});

it("goes part of the way, and back", () => {
  expect(movesOf(LIFT, 0).every((x) => Object.is(x, 0))).toBe(true);
  expect(movesOf(SWAY, -0.5)[24]).toBeCloseTo(-1.1, 12);
});

it("mixes colours whose parts sum to one, evenly bright", () => {
  for (const [x, y] of [
    [0, 0],
    [0.3, 0.8],
    [0.5, 0.5],
    [1, 0.2],
  ] as const) {
    expect(thirds(x, y).reduce((sum, part) => sum + part, 0)).toBeCloseTo(1, 12);
    expect(Math.max(...shade(thirds(x, y)))).toBeGreaterThan(110);
  }
  expect(shade(thirds(0, 1))).toEqual([236, 28, 28]);
  expect(shade(thirds(1, 0))).toEqual([28, 28, 242]);
  expect(plainShade(thirds(0, 1))).toBe("#ec1c1c");
  expect(DRAGON_COLOURS).toHaveLength(16);
  expect(DRAGON_COLOURS.every((colour) => /^#[0-9a-f]{6}$/.test(colour))).toBe(true);
  expect(DRAGON_COLOURS[0]).not.toBe(DRAGON_COLOURS[15]);
});
