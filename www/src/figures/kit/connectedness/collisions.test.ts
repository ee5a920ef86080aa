import { describe, expect, it } from "vitest";
import { Collisions, groups, windowOf } from "./collisions";

const cloud = (...points: [x: number, y: number, piece: number][]) => ({
  positions: new Float32Array(points.flatMap((point) => point.slice(0, 2))),
  pieces: new Uint8Array(points.map(([, , piece]) => piece)),
});
const unit = { x: 0, y: 0, side: 1 };

describe("Collisions", () => {
  it("puts the lowest y in the last row, and keeps stray points inside", () => {
    const run = new Collisions(2, unit, cloud([0.1, 0.1, 0], [0.9, 0.9, 1], [1, 1, 1], [-5, 9, 2]));
    run.plotTo(9);
    expect([...run.buffer]).toEqual([3, 2, 1, 0]);
    expect(run.count).toBe(4);
  });
  it("joins two pieces in the first pixel they share, once", () => {
    const run = new Collisions(2, unit, cloud([0.1, 0.1, 1], [0.2, 0.2, 0], [0.1, 0.2, 1], [0.3, 0.1, 1]));
    run.plotTo(1);
    expect(run.edges).toEqual([]);
    run.plotTo(4);
    expect(run.edges).toEqual([{ between: [0, 1], at: 2, pixel: 2 }]);
    expect(run.collisions).toBe(2);
    expect([...run.met]).toEqual([0, 0, 2, 0]);
  });
  it("does the same in one go as in steps, and never goes back", () => {
    const points = cloud(
      ...Array.from({ length: 200 }, (_, i): [number, number, number] => [
        (i * 0.37) % 1,
        (i * 0.61) % 1,
        i % 3,
      ]),
    );
    const once = new Collisions(4, unit, points);
    once.plotTo(200);
    const steps = new Collisions(4, unit, points);
    for (let i = 0; i <= 200; i += 7) steps.plotTo(i);
    steps.plotTo(200);
    steps.plotTo(3);
    expect(steps.edges).toEqual(once.edges);
    expect(steps.buffer).toEqual(once.buffer);
    expect(steps.count).toBe(200);
  });
});

describe("windowOf", () => {
  it("is square, in the middle, and lives with a point", () => {
    expect(windowOf([0, 0], [4, 2], 0.5)).toEqual({ x: -1, y: -2, side: 6 });
    expect(windowOf([3, 3], [3, 3])).toEqual({ x: 2.5, y: 2.5, side: 1 });
  });
});

describe("groups", () => {
  it("counts what hangs together", () => {
    expect(groups(4, [[0, 2]])).toEqual({ of: [0, 1, 0, 2], count: 3 });
    expect(
      groups(4, [
        [0, 1],
        [2, 3],
        [1, 3],
      ]).count,
    ).toBe(1);
    expect(groups(0, [])).toEqual({ of: [], count: 0 });
    expect(groups(1, [])).toEqual({ of: [0], count: 1 });
  });
});
