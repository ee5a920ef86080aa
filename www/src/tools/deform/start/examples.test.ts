import { describe, expect, it } from "vitest";
import { AT_REST } from "#document/deform/bend";
import { exampleOf } from "./examples";
import { motionOf } from "./motions";

const height = Math.sqrt(3) / 2;
const hull: [number, number][] = [
  [0, 0],
  [1, 0],
  [0.5, height],
];
const around = { ...AT_REST, box: [-0.05, -0.05, 1.05, 0.92] as [number, number, number, number] };

describe("exampleOf", () => {
  it("lifts the middle of the gasket's right side", () => {
    const { deformation, moves } = exampleOf(around, { preset: "gasket" }, { hull });
    expect(moves).toBe(false);
    expect(deformation.keys).toHaveLength(1);
    const all = deformation.keys[0]?.moves ?? [];
    let most = 0;
    let where = -1;
    for (let i = 0; i < 16; i++) {
      const length = Math.hypot(all[2 * i] ?? 0, all[2 * i + 1] ?? 0);
      if (length > most) [most, where] = [length, i];
    }
    // The middle of that side lies near column 3 of 4, half-way between rows 2 and 3.
    expect(where % 4).toBe(2);
    expect([1, 2]).toContain(Math.floor(where / 4));
    expect((all[2 * where] ?? 0) / (all[2 * where + 1] ?? 1)).toBeCloseTo(Math.sqrt(3), 2);
  });

  it("lets a fern sway, from rest", () => {
    const bent = { ...around, keys: [{ at: 0, moves: new Array<number>(32).fill(1) }] };
    const { deformation, moves } = exampleOf(bent, { preset: "fern" }, { hull });
    expect(moves).toBe(true);
    expect(motionOf(deformation)).toBe("sway");
    expect(deformation.keys[0]?.moves.every((x) => x === 0)).toBe(true);
  });

  it("stands a hull that is a point or a line", () => {
    for (const flat of [
      [],
      [[1, 1]],
      [
        [0, 0],
        [1, 0],
      ],
    ] as [number, number][][]) {
      const { deformation } = exampleOf(around, {}, { hull: flat });
      expect(deformation.keys[0]?.moves.every(Number.isFinite)).toBe(true);
    }
  });
});
