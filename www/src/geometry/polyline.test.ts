import { describe, expect, it } from "vitest";
import type { Uv } from "./path";
import {
  clamp,
  clipped,
  hitHandle,
  insert,
  move,
  nearestOn,
  piecesIn,
  remove,
  slice,
  sliced,
  widestAlong,
} from "./polyline";

const bent: Uv[] = [
  [0, 0],
  [0, 1],
  [1, 1],
];

describe("nearestOn", () => {
  it("finds the foot of the perpendicular and its moment", () => {
    expect(nearestOn(bent, [0.2, 0.5])).toMatchObject({ at: [0, 0.5], segment: 0, t: 0.25 });
    expect(nearestOn(bent, [0.5, 2])).toMatchObject({ at: [0.5, 1], segment: 1, t: 0.75, distance: 1 });
  });
  it("stops at the ends", () => {
    expect(nearestOn(bent, [-1, -1])).toMatchObject({ at: [0, 0], t: 0 });
    expect(nearestOn(bent, [5, 5])).toMatchObject({ at: [1, 1], t: 1 });
  });
  it("lives with doubled points and with no length at all", () => {
    const doubled: Uv[] = [
      [0, 0],
      [0, 0],
      [1, 1],
      [1, 1],
    ];
    expect(nearestOn(doubled, [0.5, 0.5])).toMatchObject({ segment: 1, t: 0.5 });
    expect(nearestOn([[2, 3]], [2, 4])).toMatchObject({ at: [2, 3], distance: 1, t: 0 });
  });
});

describe("hitHandle", () => {
  const handles: Uv[] = [
    [0, 0],
    [0.1, 0],
    [0.1, 0],
  ];
  it("takes the nearest in reach, and of equals the first", () => {
    expect(hitHandle(handles, [0.06, 0], 0.2)).toBe(1);
    expect(hitHandle(handles, [0.02, 0], 0.2)).toBe(0);
  });
  it("finds nothing out of reach", () => {
    expect(hitHandle(handles, [0.5, 0], 0.2)).toBe(-1);
    expect(hitHandle([], [0, 0], 1)).toBe(-1);
  });
});

describe("slice", () => {
  it("cuts between moments and keeps the corner", () => {
    expect(slice(bent, 0.25, 0.75)).toEqual([
      [0, 0.5],
      [0, 1],
      [0.5, 1],
    ]);
    expect(slice(bent, 0.1, 0.2)).toHaveLength(2);
    expect(slice(bent, 0, 1)).toEqual(bent);
  });
});

describe("waypoints", () => {
  const way: Uv[] = [
    [0.1, 0.1],
    [0.2, 0.2],
  ];
  it("are added, moved and removed without touching the list", () => {
    expect(insert(way, 1, [0.5, 0.5])[1]).toEqual([0.5, 0.5]);
    expect(insert(way, 2, [0.5, 0.5])).toHaveLength(3);
    expect(move(way, 0, [0, 0])).toEqual([
      [0, 0],
      [0.2, 0.2],
    ]);
    expect(remove(way, 0)).toEqual([[0.2, 0.2]]);
    expect(way).toHaveLength(2);
  });
  it("stay on the square and are short to write", () => {
    expect(clamp([-5, 5], { u0: -1, v0: -1, u1: 2, v1: 2 })).toEqual([-1, 2]);
  });
});

describe("widestAlong", () => {
  const field = {
    width: 2,
    height: 2,
    bounds: { u0: 0, v0: 0, u1: 1, v1: 1 },
    state: new Uint8Array([1, 2, 255, 0]),
    gap: new Float32Array([0, 0.25, Number.NaN, 0]),
    progress: 1,
  };
  const along = (...points: Uv[]) => widestAlong(field, points);
  it("reads the widest broken sample", () => {
    expect(along([0, 0], [1, 0])).toBe(0.25);
    expect(along([0, 0], [0.2, 0])).toBe(0);
  });
  it("is null where nothing is decided yet, or off the field", () => {
    expect(along([0, 1], [0.2, 1])).toBeNull();
    expect(along([5, 5], [6, 6])).toBeNull();
  });
});

describe("a line in a window", () => {
  const frame = { u0: 0, v0: 0, u1: 1, v1: 1 };
  it("is cut at its edges", () => {
    expect(clipped([-1, 0.5], [3, 0.5], frame)).toEqual([
      [0, 0.5],
      [1, 0.5],
    ]);
    expect(clipped([0.2, 0.3], [0.4, 0.5], frame)).toEqual([
      [0.2, 0.3],
      [0.4, 0.5],
    ]);
    expect(clipped([-1, 0.5], [0.5, 2.5], frame)).toBeNull();
    expect(clipped([2, -5], [2, 5], frame)).toBeNull();
    expect(clipped([0.5, 0.5], [0.5, 0.5], frame)).not.toBeNull();
  });
  it("keeps to numbers that can be drawn, however small the window", () => {
    const deep = { u0: 0.3, v0: 0.3, u1: 0.3 + 1e-12, v1: 0.3 + 1e-12 };
    const pieces = piecesIn(
      [
        [0, 0],
        [1, 1],
      ],
      deep,
    );
    expect(pieces).toHaveLength(1);
    for (const [u, v] of pieces.flat()) {
      expect(Math.abs(u - 0.3)).toBeLessThan(2e-12);
      expect(Math.abs(v - 0.3)).toBeLessThan(2e-12);
    }
  });
  it("is near to a slice where its w is", () => {
    const { near, far } = sliced(
      [
        [0, 0],
        [1, 0, 1],
        [2, 0, 1],
      ],
      0.5,
      0.1,
    );
    expect(near).toHaveLength(1);
    expect(near[0]?.[0][0]).toBeCloseTo(0.4, 9);
    expect(near[0]?.[1][0]).toBeCloseTo(0.6, 9);
    expect(far).toHaveLength(3);
    expect(
      sliced(
        [
          [0, 0],
          [1, 1],
        ],
        0,
        0.1,
      ).far,
    ).toEqual([]);
  });
});
