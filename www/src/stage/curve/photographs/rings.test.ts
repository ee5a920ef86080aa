import { expect, it } from "vitest";
import { placesOf, ringAt, type Traced } from "./rings";

/** A square of four edges, and the same with a vertex more on one of them. */
const square: Traced = { points: Float64Array.of(0, 0, 4, 0, 4, 4, 0, 4), edges: [0, 1, 2, 3] };
const tall: Traced = {
  points: Float64Array.of(0, 0, 1, 0, 4, 0, 4, 12, 0, 12),
  edges: [0, 0, 1, 2, 3],
};

it("finds a place at the same share of its edge", () => {
  const places = [
    { edge: 0, share: 0.5 },
    { edge: 1, share: 0.25 },
    { edge: 3, share: 1 },
  ];
  expect([...ringAt(square, 4, places)]).toEqual([2, 0, 4, 1, 0, 0]);
  expect([...ringAt(tall, 4, places)]).toEqual([2, 0, 4, 3, 0, 0]);
});

it("spreads places over both curves", () => {
  const places = placesOf([square, tall], 4, 32);
  expect(places).toHaveLength(32);
  const each = [0, 1, 2, 3].map((edge) => places.filter((place) => place.edge === edge).length);
  // An edge is a quarter of the square around; of the other an eighth, or three.
  expect(each).toEqual([6, 10, 6, 10]);
  for (const { share } of places) {
    expect(share).toBeGreaterThanOrEqual(0);
    expect(share).toBeLessThanOrEqual(1);
  }
});

it("takes an edge without length as a place", () => {
  const flat: Traced = { points: Float64Array.of(0, 0, 4, 0, 4, 4), edges: [0, 2, 3] };
  expect([...ringAt(flat, 4, [{ edge: 1, share: 0.5 }])]).toEqual([4, 0]);
  expect(placesOf([flat], 4, 9).some(({ edge }) => edge === 1)).toBe(false);
});
