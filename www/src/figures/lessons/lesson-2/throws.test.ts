import { describe, expect, it } from "vitest";
import { HEIGHT } from "../../kit/maps/families";
import { CORNERS, holes, isInMiddle, landed, START, Throws, weights } from "./throws";

describe("the chaos game by hand", () => {
  it("goes half of the way", () => {
    const game = new Throws();
    game.throwTo(1);
    expect(game.here).toEqual([(START[0] + 1) / 2, START[1] / 2]);
    expect(game.corners).toEqual([1]);
  });

  it("never throws into the middle, though it begins there", () => {
    expect(isInMiddle(START)).toBe(true);
    const game = new Throws();
    game.roll(10_000);
    expect(game.count).toBe(10_000);
    expect(game.inMiddle).toBe(0);
  });

  it("is the same at every try, and fair", () => {
    const [one, other] = [new Throws(), new Throws()];
    one.roll(3000);
    for (let i = 0; i < 30; i++) other.roll(100);
    expect(one.here).toEqual(other.here);
    for (const corner of [0, 1, 2]) {
      expect(one.corners.filter((c) => c === corner).length).toBeGreaterThan(900);
    }
  });
});

it("weighs corners", () => {
  for (const [i, corner] of CORNERS.entries()) {
    const found = weights(corner);
    expect(found[i]).toBeCloseTo(1, 12);
    expect(found.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 12);
  }
  expect(isInMiddle([0.5, 0])).toBe(false);
  // Weights 0.45, 0.45 and 0.1: near the edge of the middle, and in it.
  expect(isInMiddle([0.5, 0.1 * HEIGHT])).toBe(true);
  expect(isInMiddle([0.5, 0.51 * HEIGHT])).toBe(false);
});

it("names the holes of each level", () => {
  expect(holes(0)).toEqual([]);
  expect(holes(3)).toHaveLength(1 + 3 + 9);
  for (const hole of holes(1)) {
    const middle = hole.reduce<[number, number]>(([x, y], [u, v]) => [x + u / 3, y + v / 3], [0, 0]);
    expect(isInMiddle(middle)).toBe(true);
  }
});

it("lands in a piece of a piece by its last two throws, whatever came before", () => {
  const landedIn = (...corners: number[]) => landed(corners);
  expect(landedIn()).toBe("none");
  expect(landedIn(2, 1)).toBe("there");
  expect(landedIn(0, 0, 2, 1)).toBe("there");
  expect(landedIn(1)).toBe("large");
  expect(landedIn(1, 2)).toBe("turned");
  expect(landedIn(2, 1, 0)).toBe("elsewhere");
  // By the places of the marks, too: the piece lies between 0.5 and 1 across, and its top part above a quarter.
  const game = new Throws();
  for (const corner of [2, 1]) game.throwTo(corner);
  const [, second, third] = weights(game.here);
  expect(second).toBeGreaterThanOrEqual(0.5);
  expect(third).toBeGreaterThanOrEqual(0.25);
});
