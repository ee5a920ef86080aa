import { describe, expect, it } from "vitest";
import { type Point, pointAt } from "#geometry/maps/orbit";
import type { MapRow } from "#wasm/api";
import {
  applied,
  back,
  choose,
  factsOf,
  follow,
  isFull,
  MOST_READ,
  MOST_STEPS,
  type Orbit,
  readOn,
  startAgain,
  turnTo,
} from "./follow";
import { addressText, gameSpoken, gameWords, listed, orbitSpoken, orbitWords } from "./words";

const MAPS: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, 0.5],
];
const BOX = { x0: 0, y0: 0, x1: 1, y1: 1 };
const START: Orbit = { way: "apply", start: [0.5, 0.4], letters: [] };
const words = (orbit: Orbit) =>
  orbitWords(orbit, follow(MAPS, orbit), factsOf(MAPS, BOX, orbit), () => false);

describe("a point that is followed", () => {
  it("goes map by map, and back", () => {
    const orbit = [0, 2, 1].reduce(applied, START);
    const { points, address } = follow(MAPS, orbit);
    expect(points).toHaveLength(4);
    expect(addressText(address, true)).toBe("2 3 1 …");
    expect(follow(MAPS, back(orbit)).address).toEqual([2, 0]);
    expect(startAgain(orbit)).toEqual(START);
    expect(words(orbit)).toMatch(/^Step 3: map 2, to \(/);
    expect(orbitSpoken(orbit, follow(MAPS, orbit), "Step 3.")).toBe("Step 3. Address: 2 3 1.");
  });

  it("has its address read letter by letter, which is the same address again", () => {
    const orbit = [0, 2, 1, 1, 0].reduce(applied, { ...START, start: [1 / 3, 0] } as Orbit);
    let reading = turnTo("read", orbit, MAPS, BOX);
    for (let i = 0; i < 5; i++) reading = readOn(reading);
    const { points, address } = follow(MAPS, reading);
    expect(address).toEqual([0, 1, 1, 2, 0]);
    // And it is back where it began.
    const [x, y] = points.at(-1) as Point;
    expect(Math.hypot(x - 1 / 3, y)).toBeLessThan(1e-9);
    expect(words(reading)).toContain("Digit 5 is 1: the point lies in piece 1.");
    expect(turnTo("read", reading, MAPS, BOX)).toBe(reading);
  });

  it("keeps its address while the maps change", () => {
    const reading = readOn(choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0.75, 0]));
    const moved = MAPS.map(([a, b, c, d, e, f]): MapRow => [0.8 * a, b, c, 0.8 * d, e, f]);
    expect(follow(moved, reading).address).toEqual(follow(MAPS, reading).address);
    expect(follow(moved, reading).points[0]).toEqual(
      pointAt(moved, reading.way === "read" ? reading.address : []),
    );
    // Of two maps less there is nothing that the third one made.
    expect(follow(MAPS.slice(0, 1), reading).letters.every((letter) => letter === 0)).toBe(true);
  });

  it("is said to be off the shape, or in several pieces", () => {
    expect(words(START)).toContain("off the shape");
    expect(words({ ...START, start: [0.5, 0] } as Orbit)).toContain("on the shape");
    const off = choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0.5, 0.3]);
    expect(off.way).toBe("off");
    expect(words(off)).toContain("Only points of the shape have an address");
    expect([isFull(off), back(off), readOn(off)]).toEqual([true, off, off]);
    // A hand that leaves the shape and comes back reads as many letters again.
    const read = [1, 2].reduce(readOn, choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0.75, 0]));
    const left = choose(read, MAPS, BOX, [0.5, 0.3]);
    expect(follow(MAPS, choose(left, MAPS, BOX, [0.25, 0])).address).toHaveLength(2);
    // A finger is not so exact: within its reach the point is taken onto the shape.
    expect(choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0.5, 0.01], 0.05).way).toBe("read");
    const shared = readOn(choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0.5, 0]));
    expect(words(shared)).toContain("Pieces 1 and 2 share the point");
    expect(listed([0, 1, 4])).toBe("1, 2 and 5");
  });

  it("says that a flat map has no inverse", () => {
    const maps: MapRow[] = [[0, 0, 0, 0.5, 0, 0], ...MAPS.slice(1)];
    const orbit: Orbit = { way: "read", address: [0, 0, 0, 0], count: 1 };
    const told = orbitWords(orbit, follow(maps, orbit), { off: 0, pieces: [0] }, (letter) => letter === 0);
    expect(told).toContain("Map 1 flattens the shape, so it has no inverse");
  });

  it("ends somewhere", () => {
    let orbit: Orbit = START;
    for (let i = 0; i < MOST_STEPS + 5; i++) orbit = applied(orbit, 1);
    expect(follow(MAPS, orbit).points).toHaveLength(MOST_STEPS + 1);
    expect(words(orbit)).toContain("Start over");
    let reading = choose({ way: "read", address: [], count: 0 }, MAPS, BOX, [0, 0]);
    for (let i = 0; i < 99; i++) reading = readOn(reading);
    expect(follow(MAPS, reading).letters).toHaveLength(MOST_READ);
    expect(addressText(follow(MAPS, reading).address, false)).toMatch(/^(1 ){12}…$/);
  });
});

describe("the words of the game", () => {
  const game = { throws: 0, reached: false, least: 3, shown: false, target: [1, 0, 2], way: [2, 0, 1] };
  it.each([
    ["at first", {}, /^No throw yet/],
    ["on the way", { throws: 2 }, /^2 throws\. The point is not/],
    ["in more than are needed", { throws: 5, reached: true }, /Fewer are possible: start over/],
    ["in the fewest", { throws: 3, reached: true }, /^Well done.*address 2 1 3/],
    [
      "when it was shown",
      { throws: 3, reached: true, shown: true },
      /^One solution: 3, then 1, then 2\..*backwards/,
    ],
    ["when there are too many", { throws: 40 }, /is the limit/],
  ])("%s", (_, change, told) => {
    expect(gameWords({ ...game, ...change })).toMatch(told);
  });

  it("say to those who hear them where the cell is and where the point, and no letters", () => {
    const where = { here: [0.5, 0.2] as Point, centre: [0.6875, 0.25] as Point, width: 0.125 };
    const said = (change: object) => gameSpoken({ ...game, where, ...change });
    expect(said({})).toBe(
      "The framed cell is 0.125 wide, with its centre at (0.688, 0.25). No throw yet. The point is at (0.5, 0.2).",
    );
    expect(said({ throws: 2 })).toMatch(
      /^2 throws\..* at \(0\.5, 0\.2\)\. The centre .* \(0\.688, 0\.25\)\.$/,
    );
    expect(said({ throws: 3, reached: true })).toMatch(/^Well done.* The point is at \(0\.5, 0\.2\)\.$/);
  });

  it("give the address away to nobody who has not found it", () => {
    for (const throws of [0, 2, 40]) expect(gameWords({ ...game, throws })).not.toContain("2 1 3");
    expect(gameWords({ ...game, throws: 9, reached: true })).not.toContain("2 1 3");
  });
});
