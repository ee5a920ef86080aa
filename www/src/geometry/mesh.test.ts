import { describe, expect, it } from "vitest";
import type { Deformation } from "#wasm/api";
import { bentAt } from "./bezier";
import { type Mesh, placed, remesh, rest, toCount } from "./mesh";

const BOX: [number, number, number, number] = [-3, 0, 3, 10.2];

function deformation(columns: number, rows: number, more: Partial<Deformation> = {}): Deformation {
  // No two alike, and the same on every run.
  const moves = Array.from({ length: 2 * columns * rows }, (_, i) => Math.sin(12.9898 * (i + 1)) * 0.8);
  return {
    on: true,
    subject: "shape",
    parts: 2,
    columns,
    rows,
    box: BOX,
    keys: [{ at: 0, moves }],
    phase: 0,
    seconds: 4,
    loop: true,
    kb: 0,
    ke: 9,
    delta: 0.75,
    spin: "none",
    continuity: "auto",
    superposed: true,
    ...more,
  };
}

function meshOf({ columns, rows, box, keys }: Deformation): Mesh {
  return { columns, rows, box, moves: keys[0]?.moves ?? [] };
}

function farApart(p: Mesh, q: Mesh): number {
  let most = 0;
  for (let i = 0; i <= 10; i++) {
    for (let j = 0; j <= 10; j++) {
      const [[px, py], [qx, qy]] = [bentAt(p, i / 10, j / 10), bentAt(q, i / 10, j / 10)];
      most = Math.max(most, Math.hypot(px - qx, py - qy));
    }
  }
  return most;
}

describe("a mesh", () => {
  it("rests row by row from the lower left", () => {
    const mesh = { columns: 3, rows: 2, box: BOX, moves: [0, 0, 0.5, -0.25] };
    expect([0, 2, 3, 5].map((i) => rest(mesh, i))).toEqual([
      [-3, 0],
      [3, 0],
      [-3, 10.2],
      [3, 10.2],
    ]);
    expect(placed(mesh, 1)).toEqual([0.5, -0.25]);
    expect(placed(mesh, 4)).toEqual([0, 10.2]);
  });
});

describe("remesh", () => {
  it("bends exactly alike with more points", () => {
    const before = deformation(4, 4);
    for (const [columns, rows] of [
      [5, 4],
      [4, 7],
      [16, 16],
    ] as const) {
      const after = remesh(before, columns, rows);
      expect(after.keys[0]?.moves).toHaveLength(2 * columns * rows);
      expect(farApart(meshOf(before), meshOf(after))).toBeLessThan(1e-7);
    }
  });

  it("comes back through more points to where it was", () => {
    const before = deformation(4, 3);
    const back = remesh(remesh(before, 16, 16), 4, 3);
    back.keys[0]?.moves.forEach((x, i) => {
      expect(x).toBeCloseTo(before.keys[0]?.moves[i] ?? Number.NaN, 5);
    });
  });

  it("is the nearest in the mean with fewer points", () => {
    // The mean square of the difference to t^3 over [0, 1] is least for 1.5 t^2 - 0.6 t + 0.05.
    const near = toCount([0, 0, 0, 1], 3);
    expect(near[0]).toBeCloseTo(0.05, 12);
    expect(near[1]).toBeCloseTo(0.05 - 0.3, 12);
    expect(near[2]).toBeCloseTo(0.95, 12);
    // And over two degrees for the straight line 0.9 t - 0.2.
    const line = toCount([0, 0, 0, 1], 2);
    expect(line[0]).toBeCloseTo(-0.2, 12);
    expect(line[1]).toBeCloseTo(0.7, 12);
  });

  it("keeps all keys, the rest of the document, and colours that are colours", () => {
    const colours = Array.from({ length: 16 }, (_, i) => (i % 3 === 0 ? "#ff0000" : "#00ff80"));
    const tint = { colours, kb: 0, ke: 9, delta: 1, superposed: true };
    const keys = [
      { at: 0, moves: new Array<number>(32).fill(0) },
      { at: 0.5, moves: new Array<number>(32).fill(0.25) },
    ];
    const after = remesh(deformation(4, 4, { tint, keys, seconds: 7 }), 2, 9);
    expect(after.keys.map(({ at }) => at)).toEqual([0, 0.5]);
    // What is the same everywhere stays so.
    expect(after.keys[1]?.moves.every((x) => Math.abs(x - 0.25) < 1e-9)).toBe(true);
    expect(after.seconds).toBe(7);
    expect(after.tint?.colours).toHaveLength(18);
    for (const colour of after.tint?.colours ?? []) expect(colour).toMatch(/^#[0-9a-f]{6}$/);
  });

  it("takes what cannot be to what can", () => {
    const before = deformation(4, 4);
    expect(remesh(before, 4, 4)).toBe(before);
    expect(remesh(before, 1e6, Number.NaN)).toMatchObject({ columns: 16, rows: 2 });
    expect(remesh(before, 0, 3.4)).toMatchObject({ columns: 2, rows: 3 });
    expect(remesh(before, 16, 2).keys[0]?.moves.every(Number.isFinite)).toBe(true);
  });
});
