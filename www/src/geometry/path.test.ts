import { describe, expect, it } from "vitest";
import { pointsOf, thinned, timesOf, type Uv, uvAt } from "./path";

const bent: Uv[] = [
  [0, 0],
  [0, 3],
  [1, 3],
];

describe("uvAt", () => {
  it("goes by length, not by waypoint", () => {
    expect(uvAt(bent, 0.5)).toEqual([0, 2]);
    expect(uvAt(bent, 0.75)).toEqual([0, 3]);
    expect(uvAt(bent, 0.875)).toEqual([0.5, 3]);
  });

  it("hits both ends exactly", () => {
    const odd: Uv[] = [
      [0, 0],
      [0.1, 0.7],
      [1, 1],
    ];
    expect(uvAt(odd, 0)).toEqual([0, 0]);
    expect(uvAt(odd, 1)).toEqual([1, 1]);
  });

  it("clamps what lies outside, and what is no number", () => {
    expect(uvAt(bent, -3)).toEqual([0, 0]);
    expect(uvAt(bent, 7)).toEqual([1, 3]);
    expect(uvAt(bent, Number.NaN)).toEqual([0, 0]);
  });

  it("passes through points that coincide", () => {
    const twice: Uv[] = [
      [0, 0],
      [0, 0],
      [1, 1],
      [1, 1],
    ];
    expect(uvAt(twice, 0.5)).toEqual([0.5, 0.5]);
  });

  it("stays put on a path without length", () => {
    expect(uvAt([[2, 2]], 0.5)).toEqual([2, 2]);
    expect(
      uvAt(
        [
          [2, 2],
          [2, 2],
        ],
        0.5,
      ),
    ).toEqual([2, 2]);
    expect(uvAt([], 0.5)).toEqual([0, 0]);
  });
});

describe("timesOf", () => {
  it("inverts uvAt at the waypoints", () => {
    expect(timesOf(bent)).toEqual([0, 0.75, 1]);
    expect(timesOf([[0, 0]])).toEqual([0]);
  });
});

describe("pointsOf", () => {
  it("adds both ends, and passes by the waypoints of a straight path", () => {
    const points: Uv[] = [[0.2, 0.9]];
    expect(pointsOf({ kind: "drawn", points })).toEqual([
      [0, 0],
      [0.2, 0.9],
      [1, 1],
    ]);
    expect(pointsOf({ kind: "straight", points })).toEqual([
      [0, 0],
      [1, 1],
    ]);
  });
});

describe("thinned", () => {
  const round = Array.from({ length: 500 }, (_, i): Uv => [Math.cos(i / 80), Math.sin(i / 80)]);

  it("keeps within the number, and both ends", () => {
    const few = thinned(round, 66);
    expect(few.length).toBeLessThanOrEqual(66);
    expect(few[0]).toEqual(round[0]);
    expect(few.at(-1)).toEqual(round.at(-1));
  });

  it("stays near the path", () => {
    for (const [u, v] of thinned(round, 66)) expect(Math.hypot(u, v)).toBeCloseTo(1, 9);
    const gaps = timesOf(thinned(round, 66)).map((t, i, all) => t - (all[i - 1] ?? 0));
    expect(Math.max(...gaps)).toBeLessThan(0.1);
  });

  it("leaves a short path as it is", () => {
    expect(thinned(bent, 66)).toEqual(bent);
    expect(thinned([], 66)).toEqual([]);
  });

  it("ends even where all points coincide", () => {
    expect(
      thinned(
        Array.from({ length: 100 }, (): Uv => [1, 1]),
        10,
      ).length,
    ).toBeLessThanOrEqual(10);
  });
});
