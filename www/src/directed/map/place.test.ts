import { expect, it } from "vitest";
import { momentNear, place } from "./place";

it("leads from the square to the nearest moment of the way, and from its moments to the square", () => {
  for (const t of [0, 0.25, 1]) expect(momentNear(place([t, t]))).toBeCloseTo(t, 12);
  // Beside the way: straight across from it.
  expect(momentNear(place([0.2, 0.6]))).toBeCloseTo(0.4, 12);
  expect([momentNear([0, 1]), momentNear([1, 0])]).toEqual([0, 1]);
});
