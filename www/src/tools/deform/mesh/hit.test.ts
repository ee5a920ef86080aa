import { describe, expect, it } from "vitest";
import { screen } from "#geometry/coordinates";
import { inPlane, inside, nearest } from "./hit";
import { neighbour } from "./keyboard";

const POINTS = [screen(0, 0), screen(10, 0), screen(10, 40)];

describe("nearest", () => {
  it("shares the room between handles that lie close", () => {
    expect(nearest(POINTS, screen(4, 0), 22)).toBe(0);
    expect(nearest(POINTS, screen(6, 0), 22)).toBe(1);
    expect(nearest(POINTS, screen(10, 61), 22)).toBe(2);
    expect(nearest(POINTS, screen(10, 63), 22)).toBe(-1);
    expect(nearest([], screen(0, 0), 22)).toBe(-1);
  });

  it("passes by what is nowhere", () => {
    expect(nearest([screen(Number.NaN, 0)], screen(0, 0), 22)).toBe(-1);
  });
});

describe("inside", () => {
  it("takes the corners in any order", () => {
    expect(inside(POINTS, screen(20, 50), screen(5, -5))).toEqual([1, 2]);
    expect(inside(POINTS, screen(5, -5), screen(20, 50))).toEqual([1, 2]);
    expect(inside(POINTS, screen(1, 1), screen(2, 2))).toEqual([]);
  });
});

describe("a way on the stage", () => {
  it("points up in the plane", () => {
    expect(inPlane(screen(10, 10), screen(30, 0), { scale: 100 })).toEqual([0.2, 0.1]);
  });
});

describe("neighbour", () => {
  it("stops at the edge", () => {
    const mesh = { columns: 3, rows: 4 };
    expect(neighbour(mesh, 4, [1, 0])).toBe(5);
    expect(neighbour(mesh, 5, [1, 0])).toBe(5);
    expect(neighbour(mesh, 4, [0, 1])).toBe(7);
    expect(neighbour(mesh, 1, [0, -1])).toBe(1);
    expect(neighbour(mesh, 9, [0, 1])).toBe(9);
  });
});
