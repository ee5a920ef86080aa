import { describe, expect, it } from "vitest";
import {
  alongSide,
  apart,
  fromGraph,
  fromWord,
  isApart,
  norm,
  type PlaneCurve,
  sideOf,
  toWord,
  withoutPoint,
  withPiece,
  withPlace,
  withPointIn,
  withTime,
} from "./curve";
import { EXAMPLES } from "./examples";

const example = (id: string): PlaneCurve => EXAMPLES.find((one) => one.id === id)?.make() as PlaneCurve;

it("a norm is the longest image of a unit vector", () => {
  expect(norm([0.7, 0.7, 0.7, 0.7])).toBeCloseTo(1.4, 12);
  expect(norm([0, 2, 0, 0])).toBe(2);
  expect(norm([0.3, 0, 0, -0.6])).toBeCloseTo(0.6, 12);
});

describe("withPlace", () => {
  it("puts points in any order of x, and copies that lay along their sides go on to", () => {
    const moved = withPlace(example("koch"), 1, [0.9, -0.2]);
    expect(moved.points.map(([t]) => t)).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(moved.pieces.map((_, i) => sideOf(moved, i))).toEqual(["turned", "turned", "turned", "turned"]);
    const arrowhead = withPlace(example("arrowhead"), 2, [0.7, 0.3]);
    expect(arrowhead.pieces.map((_, i) => sideOf(arrowhead, i))).toEqual(["mirrored", "turned", "mirrored"]);
  });

  it("leaves other factors alone, and takes no bad number", () => {
    const leaning = example("leaning");
    expect(withPlace(leaning, 1, [2, 3]).pieces).toEqual(leaning.pieces);
    expect(withPlace(leaning, 1, [Number.NaN, 3])).toBe(leaning);
    expect(withPlace(leaning, 9, [0, 0])).toBe(leaning);
  });
});

it("a factor along a side takes the chord that is copied to the side", () => {
  for (const mirrored of [false, true]) {
    const curve = withPiece(example("apart"), 2, { span: [3, 1] });
    const [a, b, c, d] = alongSide(curve, 2, mirrored) ?? [0, 0, 0, 0];
    const [p, q] = [[0.7 - 1, 0.4 - 0.6] as const, [1 - 0.3, 0.6 - 0.8] as const];
    expect(a * p[0] + b * p[1]).toBeCloseTo(q[0], 12);
    expect(c * p[0] + d * p[1]).toBeCloseTo(q[1], 12);
    expect(Math.sign(a * d - b * c)).toBe(mirrored ? -1 : 1);
  }
  const closed = withPlace(example("apart"), 4, [0, 0]);
  expect(alongSide(closed, 0, false)).toBeNull();
});

it("a point comes and goes with its piece, and copies go on to copy what they did", () => {
  const curve = withPiece(example("apart"), 2, { span: [4, 2] });
  const more = withPointIn(curve, 1, [0.5, 0.6]);
  expect(more.points.map(([t]) => t)).toEqual([0, 0.25, 0.375, 0.5, 0.75, 1]);
  expect(more.pieces.map(({ span }) => span)).toEqual([
    [0, 5],
    [0, 5],
    [0, 5],
    [5, 3],
    [0, 5],
  ]);
  expect(withoutPoint(more, 2)).toEqual(curve);
  const other = withPiece(withPiece(example("apart"), 3, { span: [2, 0] }), 0, { span: [0, 2] });
  // What ended at the point ends at its neighbour, outwards.
  expect(withoutPoint(other, 2).pieces.map(({ span }) => span)).toEqual([
    [0, 2],
    [0, 3],
    [2, 0],
  ]);
  const upper = withPiece(example("apart"), 0, { span: [2, 4] });
  expect(withoutPoint(upper, 2).pieces[0]?.span).toEqual([1, 3]);
  // What became too long for what it copies copies all.
  const less = withoutPoint(other, 1);
  expect(less.pieces.map(({ span }) => span)).toEqual([
    [0, 3],
    [3, 0],
    [1, 0],
  ]);
  const three = withoutPoint(less, 1);
  expect(three.points.length).toBe(3);
  expect(withoutPoint(three, 1)).toBe(three);
  expect(withoutPoint(curve, 0)).toBe(curve);
});

it("t stays between its neighbours", () => {
  expect(withTime(example("koch"), 1, 0.9).points[1]?.[0]).toBeCloseTo(0.4999, 6);
  expect(withTime(example("koch"), 1, 0.3).points[1]?.[0]).toBe(0.3);
});

it("apart is what knows nothing of the other", () => {
  expect(isApart(example("apart"))).toBe(true);
  expect(isApart(example("leaning"))).toBe(false);
  expect(isApart(apart(example("leaning")))).toBe(true);
});

it("parts of a graph that end between points are left to what cuts them", () => {
  expect(
    fromGraph({ kind: "pfif", pieces: [{ map: [0.5, 0, 0.5, 0, 0], domain: [0, 1] }] }, () => 0),
  ).toBeNull();
});

describe("words", () => {
  it("hold a curve to the last digit", () => {
    for (const { make } of EXAMPLES) expect(fromWord(toWord(make()))).toEqual(make());
    const far = withPlace(example("apart"), 1, [1e30, -1e-30]);
    expect(toWord(far)).toMatch(/^[\d.,;:e-]+$/);
    expect(fromWord(toWord(far))).toEqual(far);
  });

  it("that hold none are told apart", () => {
    for (const word of [
      "",
      "0,0,0",
      "0,0,0;1,1,0:",
      "0,0,0;1,1,0:0,0,0,0,0",
      "0,0,0;1,1,0:0,0,0,0,0,2",
      "0,0,0;1,1,0:0,0,0,0,0,0.5",
      "0,0,0;1,1,0:0,0,0,0,-1,1",
      "0,0,0;1,1:0,0,0,0,0,1",
      "0,0,0;1,,0:0,0,0,0,0,1",
      "0,0,0;1,1,0;2,2,0:0,0,0,0,0,1",
      "0,0,0;1,1,0:0,0,0,0,0,1:",
      "0,0,0;1e999,1,0:0,0,0,0,0,1",
      `${"0,0,0;".repeat(300)}1,1,0:${"0,0,0,0,0,1;".repeat(299)}0,0,0,0,0,1`,
    ]) {
      expect(fromWord(word), word.slice(0, 40)).toBeNull();
    }
  });
});
