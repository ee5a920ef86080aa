import { describe, expect, it } from "vitest";
import { type Curve, meeting, onBorder, onRight, placeOf, pointsOf, takeTurns } from "./curves";

const PLACES = Array.from({ length: 12 }, (_, i) => (i + 0.41) / 3);
const SWINGS = [-0.6, -0.25, 0, 0.3, 0.6];

it("goes round the border and back", () => {
  for (const place of [0, 0.3, 1, 1.5, 2.2, 3, 3.9]) expect(placeOf(onBorder(place))).toBeCloseTo(place, 12);
  expect(onBorder(4.5)).toEqual([0.5, 0]);
  expect(onBorder(-0.5)).toEqual([0, 0.5]);
});

it("stays in the square, from end to end", () => {
  const curve: Curve = { from: 3.5, to: 0.2, swing: 0.6 };
  const points = pointsOf(curve);
  for (const [x, y] of points) expect(Math.min(x, y, 1 - x, 1 - y)).toBeGreaterThanOrEqual(0);
  for (const [i, place] of [curve.from, curve.to].entries()) {
    const [x, y] = onBorder(place);
    const end = points.at(-i);
    expect(end?.[0]).toBeCloseTo(x, 12);
    expect(end?.[1]).toBeCloseTo(y, 12);
  }
});

describe("curves whose ends take turns", () => {
  it("meet, however they swing", () => {
    let tried = 0;
    for (const from of PLACES)
      for (const to of PLACES)
        for (const [i, swing] of SWINGS.entries()) {
          const a: Curve = { from: 3.5, to: 1.2, swing: SWINGS[(2 * i) % 5] ?? 0 };
          const b: Curve = { from, to, swing };
          if (!takeTurns(a, b)) continue;
          tried++;
          expect(meeting(a, b), JSON.stringify([a, b])).not.toBeNull();
        }
    expect(tried).toBeGreaterThan(100);
  });

  it("are told from others, which can be apart", () => {
    const a: Curve = { from: 3.5, to: 1.5, swing: 0 };
    expect(takeTurns(a, { from: 0.5, to: 2.5, swing: 0 })).toBe(true);
    expect(takeTurns(a, { from: 2.5, to: 0.5, swing: 0 })).toBe(true);
    expect(takeTurns(a, { from: 1.2, to: 1.8, swing: 0 })).toBe(true);
    expect(takeTurns(a, { from: 0.2, to: 0.8, swing: 0 })).toBe(false);
    // An end on an end is no turn.
    expect(takeTurns(a, { from: 3.5, to: 2.5, swing: 0 })).toBe(false);
    expect(meeting({ ...a, from: 3.2, to: 2.8 }, { from: 0.4, to: 1.2, swing: 0 })).toBeNull();
  });
});

it("asks for both ends on the right side", () => {
  expect(onRight({ from: 1.2, to: 1.8, swing: 0 })).toBe(true);
  expect(onRight({ from: 0.8, to: 1.8, swing: 0 })).toBe(false);
});
