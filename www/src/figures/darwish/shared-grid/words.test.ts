import { describe, expect, it } from "vitest";
import { copiesOf, dimensionWords, graphWords, verdictOf, waysOf } from "./words";

const copy = (digit: number, to: number) => ({ digit, to });
const states = [
  { shifts: [[1, 0]] as [number, number][], copies: [copy(0, 1), copy(1, 1)] },
  { shifts: [[3, 0]] as [number, number][], copies: [copy(1, 0)] },
];
const found = {
  states,
  addresses: "uncountable" as const,
  points: null,
  attractor: null,
  isExact: true,
  dimension: 0.31546,
};
const map = [0.1, 0, 0, 0.1, 0, 0] as [number, number, number, number, number, number];

describe("what two shapes share", () => {
  it("is a graph with the copies of a kind together", () => {
    expect(copiesOf(found)).toEqual([
      { from: 0, to: 1, digits: [0, 1] },
      { from: 1, to: 0, digits: [1] },
    ]);
    expect(waysOf(found)).toEqual([
      { from: 0, to: 1, label: "2" },
      { from: 1, to: 0, label: "1" },
    ]);
    expect(graphWords(found)).toBe(
      "2 kinds of pieces: kind 0 holds 2 copies of kind 1, kind 1 holds one copy of kind 0.",
    );
  });

  it("is said to be what it is, and no more", () => {
    const title = (more: Partial<Parameters<typeof verdictOf>[0]>) => verdictOf({ ...found, ...more }).title;
    expect(title({ states: [] })).toBe("They do not meet.");
    expect(title({ addresses: 2, points: [[0, 0]] })).toBe("They share one point.");
    expect(
      title({
        addresses: 2,
        points: [
          [0, 0],
          [1, 0],
        ],
      }),
    ).toMatch(/2 points/);
    expect(title({ addresses: 9000, points: null })).toBe("They share finitely many points.");
    expect(title({ attractor: [map, map] })).toMatch(/^It is an attractor again, of 2 maps/);
    expect(title({})).toBe("It is made of 2 kinds of pieces.");
    expect(verdictOf({ ...found, addresses: "countable" }).text).toMatch(/countably many/);
  });

  it("has a dimension, or a bound of it", () => {
    expect(dimensionWords(found)).toBe("0.3155");
    expect(dimensionWords({ ...found, isExact: false })).toBe("at most 0.3155");
    expect(dimensionWords({ ...found, states: [] })).toBe("–");
  });
});
