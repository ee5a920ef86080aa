import { describe, expect, it, test } from "vitest";
import type { MapRow } from "#wasm/api";
import { after2, compose, decompose, determinant, mapWords, reflect } from "./affine2";

const close = (got: MapRow, want: MapRow) => {
  got.forEach((x, i) => {
    expect(x).toBeCloseTo(want[i] ?? Number.NaN, 12);
  });
};

const cases: Record<string, MapRow> = {
  identity: [1, 0, 0, 1, 0, 0],
  "half turn": [-0.5, 0, 0, -0.5, 1, 2],
  reflection: [0.5, 0, 0, -0.5, 0, 1],
  "reflection of x": [-0.5, 0, 0, 0.5, 0, 1],
  shear: [0.5, 0.3, 0, 0.5, 0, 0],
  fern: [0.85, 0.04, -0.04, 0.85, 0, 1.6],
  stem: [0, 0, 0, 0.16, 0, 0],
  "flat, leaning": [0, 0.3, 0, 0.4, 0, 0],
  "all to a point": [0, 0, 0, 0, 3, 4],
  "flat onto a line": [0.2, 0.1, 0.4, 0.2, 0, 0],
  "hardly there": [1e-12, 0, 0, 1e-12, 0, 0],
};

describe("turn, stretch and move", () => {
  it.each(Object.entries(cases))("comes back: %s", (_, map) => close(compose(decompose(map)), map));

  it("comes back for many turns and stretches", () => {
    for (let turn = -179; turn <= 180; turn += 7)
      for (const stretchY of [-0.7, 0, 0.4]) {
        const parts = { turn, stretchX: 0.6, stretchY, slant: 0.1, moveX: -1, moveY: 2 };
        const back = decompose(compose(parts));
        expect(back.turn).toBeCloseTo(turn, 9);
        expect(back.stretchX).toBeCloseTo(0.6, 12);
        expect(back.stretchY).toBeCloseTo(stretchY, 12);
        expect(back.slant).toBeCloseTo(0.1, 12);
      }
  });

  it("says a quarter turn in whole numbers", () => {
    expect(compose({ turn: 90, stretchX: 0.5, stretchY: 0.5, slant: 0, moveX: 0, moveY: 0 })).toEqual([
      0, -0.5, 0.5, 0, 0, 0,
    ]);
  });

  it("gives a half turn as 180, never as -180", () => {
    expect(decompose([-0.5, 0, -0, -0.5, 0, 0]).turn).toBe(180);
  });

  it("marks a reflection by a negative y stretch", () => {
    expect(decompose([-0.5, 0, 0, 0.5, 0, 0])).toMatchObject({ stretchX: 0.5, stretchY: -0.5, turn: 180 });
  });
});

describe("reflect", () => {
  it("is its own inverse, and turns the sign of the determinant", () => {
    for (const map of Object.values(cases)) {
      close(reflect(reflect(map, 0.7), 0.7), map);
      expect(determinant(reflect(map, 0.7))).toBeCloseTo(-determinant(map), 12);
    }
  });
  it("leaves the image of the mirror line where it is", () => {
    const [a, b, c, d, e, f] = reflect([0.5, 0.1, 0.2, 0.4, 1, 2], 0.7);
    expect(a * 0.7 + b * 3 + e).toBeCloseTo(0.5 * 0.7 + 0.1 * 3 + 1, 12);
    expect(c * 0.7 + d * 3 + f).toBeCloseTo(0.2 * 0.7 + 0.4 * 3 + 2, 12);
  });
});

describe("mapWords", () => {
  it("names size, turn and mirror", () => {
    expect(mapWords([0.5, 0, 0, 0.5, 0, 0])).toBe("×0.5");
    expect(mapWords([0, -0.5, 0.5, 0, 0, 0])).toBe("×0.5, turned 90°");
    expect(mapWords([0.5, 0, 0, -0.5, 0, 0])).toBe("×0.5, mirrored");
    expect(mapWords([0, 0, 0, 0.16, 0, 0])).toBe("flat");
  });
});

test("one map after another", () => {
  expect(after2([0, -1, 1, 0, 3, 1], [2, 0, 0, 3, 4, 5])).toEqual([0, -3, 2, 0, -2, 5]);
  for (const map of Object.values(cases)) close(after2(map, [1, 0, 0, 1, 0, 0]), map);
});
