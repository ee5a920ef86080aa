import { describe, expect, it } from "vitest";
import { apply3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3 } from "#wasm/api";
import {
  findingOf,
  graphWords,
  inner,
  isFlat,
  pairWords,
  placed,
  sharesLinear,
  shiftWords,
  waysOf,
} from "./meets";

const third = (x: number, y = 0, z = 0): MapRow3 => [1 / 3, 0, 0, 0, 1 / 3, 0, 0, 0, 1 / 3, x, y, z];
const arrows = [
  { from: 0, first: 0, second: 1, to: 0 },
  { from: 0, first: 2, second: 0, to: 1 },
  { from: 0, first: 1, second: 1, to: 0 },
];

describe("the graph of shifts", () => {
  it("holds ways between the same shifts together", () => {
    expect(waysOf({ arrows })).toEqual([
      {
        from: 0,
        to: 0,
        pairs: [
          [0, 1],
          [1, 1],
        ],
      },
      { from: 0, to: 1, pairs: [[2, 0]] },
    ]);
  });

  it("is said in words", () => {
    expect(pairWords([[2, 0]])).toBe("3 · 1");
    expect(
      pairWords([
        [2, 0],
        [1, 1],
      ]),
    ).toBe("2 ways");
    const shifts: Point3[] = [
      [0, 0, 0],
      [1, 0, 0],
    ];
    expect(graphWords({ shifts, arrows })).toBe(
      "2 shifts, of which 0 is none at all. Ways: from 0 to 0 by 2 pairs, from 0 to 1 by one pair.",
    );
    expect(graphWords({ shifts: [], arrows: [] })).toContain("do not meet");
    expect(shiftWords([0.5, -1 / 3, 0])).toBe("(0.5, −0.333, 0)");
  });

  it("comes to one of three things", () => {
    expect(findingOf({ shifts: [], attractor: null })).toBe("apart");
    expect(findingOf({ shifts: [[0, 0, 0]], attractor: [third(0)] })).toBe("one");
    expect(findingOf({ shifts: [[0, 0, 0]], attractor: null })).toBe("several");
  });
});

describe("a shape in its place", () => {
  it("is the same as its points scaled and moved", () => {
    const map = third(0.5, 0.25, -1);
    const [moved] = placed([map], 2, [3, -1, 0.5]);
    const to = (p: Point3): Point3 => [2 * p[0] + 3, 2 * p[1] - 1, 2 * p[2] + 0.5];
    const point: Point3 = [0.3, 0.7, -0.2];
    const [x, y] = [apply3(moved as MapRow3, to(point)), to(apply3(map, point))];
    x.forEach((at, k) => {
      expect(at).toBeCloseTo(y[k] ?? Number.NaN, 12);
    });
  });

  it("keeps its linear part", () => {
    expect(sharesLinear(placed([third(0), third(0.5)], 3, [1, 2, 3]))).toBe(true);
    expect(sharesLinear([third(0), [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0]])).toBe(false);
    expect(sharesLinear([])).toBe(false);
  });

  it("lies in another whose maps hold its own", () => {
    const [few, many] = [
      [third(0), third(0.5)],
      [third(0.2), third(0.5), third(0)],
    ];
    expect(inner(few, many)).toBe("first");
    expect(inner(many, few)).toBe("second");
    expect(inner(few, few)).toBe("first");
    expect(inner(few, [third(0), third(0.6), third(0.7)])).toBeNull();
  });

  it("is flat or not", () => {
    expect(isFlat([third(0.1, 0.2)])).toBe(true);
    expect(isFlat([third(0.1, 0.2, 0.3)])).toBe(false);
  });
});
