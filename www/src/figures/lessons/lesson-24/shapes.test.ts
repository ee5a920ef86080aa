import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import {
  eyeOf,
  LYING,
  NEAR_DEGREES,
  offDiagonal,
  offEdges,
  SPONGE,
  STANDING,
  shadowMaps,
  viewOf,
} from "./shapes";

/** The different places of the copies in a shadow. */
const places = (maps: readonly MapRow[]) =>
  new Set(
    maps.map(([, , , , e, f]) =>
      `${(e + 0).toFixed(6)} ${(f + 0).toFixed(6)}`.replaceAll("-0.000000", "0.000000"),
    ),
  );
const DIAGONAL = { turn: 45, tilt: (Math.atan(Math.SQRT1_2) * 180) / Math.PI };

describe("the sponge", () => {
  it("has 20 copies, and from the front the eight places of the carpet", () => {
    expect(SPONGE).toHaveLength(20);
    const seen = places(shadowMaps(SPONGE, { turn: 0, tilt: 0 }));
    expect(seen.size).toBe(8);
    expect(seen).not.toContain("0.000000 0.000000");
  });

  it("takes along the diagonal all 19 places that the whole cube takes", () => {
    const sides = [-1, 0, 1];
    const cube = sides.flatMap((x) => sides.flatMap((y) => sides.map((z) => [x, y, z] as const)));
    const whole = cube.map(
      ([x, y, z]) => [1 / 3, 0, 0, 0, 1 / 3, 0, 0, 0, 1 / 3, (2 / 3) * x, (2 / 3) * y, (2 / 3) * z] as const,
    );
    const all = places(
      shadowMaps(
        whole.map((map) => [...map]),
        DIAGONAL,
      ),
    );
    expect(all.size).toBe(19);
    expect(places(shadowMaps(SPONGE, DIAGONAL))).toEqual(all);
  });
});

it("makes a square of four squares below the lying tetrahedron", () => {
  const seen = places(shadowMaps(LYING, { turn: 0, tilt: 90 }));
  expect([...seen].sort()).toEqual([
    "-0.500000 -0.500000",
    "-0.500000 0.500000",
    "0.500000 -0.500000",
    "0.500000 0.500000",
  ]);
});

it("stands a tetrahedron with equal edges on a face, as large as the other one", () => {
  for (const maps of [LYING, STANDING]) {
    const corners = maps.map((map) => [2 * map[9], 2 * map[10], 2 * map[11]] as const);
    for (const [i, p] of corners.entries())
      for (const q of corners.slice(i + 1))
        expect(Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])).toBeCloseTo(2 * Math.SQRT2, 9);
  }
});

describe("the exercises", () => {
  it("are solved in whole degrees, and not at the start", () => {
    expect(offDiagonal({ turn: 45, tilt: 35 })).toBeLessThan(NEAR_DEGREES);
    expect(offDiagonal({ turn: -135, tilt: -35 })).toBeLessThan(NEAR_DEGREES);
    expect(offDiagonal({ turn: 0, tilt: 0 })).toBeCloseTo(54.7, 1);
    expect(offEdges({ turn: 10, tilt: 0 })).toBeGreaterThan(30);
  });

  it("take for the right way to light the tetrahedron one whose shadow is a square", () => {
    const tilt = DIAGONAL.tilt;
    const good = [0, 60, 120, 180, -60, -120, 30, 90, 150].flatMap((turn) => [
      { turn, tilt },
      { turn, tilt: -tilt },
    ]);
    const found = good.filter((eye) => offEdges(eye) < 1e-3);
    expect(found.length).toBeGreaterThan(0);
    for (const eye of found) {
      const middles = shadowMaps(STANDING, eye).map(([, , , , e, f]) => Math.hypot(e, f));
      // Four corners as far from the middle, in two pairs that face each other: a rectangle with equal diagonals.
      for (const middle of middles) expect(middle).toBeCloseTo(Math.SQRT1_2, 6);
      const [a, b, c, d] = shadowMaps(STANDING, eye).map(([, , , , e, f]) => [e, f] as const);
      const dots = [b, c, d]
        .map((p) => (a && p ? a[0] * p[0] + a[1] * p[1] : Number.NaN))
        .sort((x, y) => x - y);
      expect(dots[0]).toBeCloseTo(-0.5, 6);
      expect(dots[1]).toBeCloseTo(0, 6);
      expect(dots[2]).toBeCloseTo(0, 6);
    }
  });
});

it("turns views to degrees and back", () => {
  const eye = eyeOf(viewOf({ turn: 33, tilt: -12 }));
  expect(eye.turn).toBeCloseTo(33, 9);
  expect(eye.tilt).toBeCloseTo(-12, 9);
});
