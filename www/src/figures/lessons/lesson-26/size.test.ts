import { expect, it } from "vitest";
import { dustDimension, LINE, PLANE } from "./size";

it("is that of a line at one half, and that of the plane at the root of one half", () => {
  expect(dustDimension(LINE)).toBeCloseTo(1, 12);
  expect(dustDimension(PLANE)).toBeCloseTo(2, 12);
  expect(dustDimension(0.25)).toBeCloseTo(0.5, 12);
  // Moran's equation itself.
  for (const size of [0.3, 0.55, 0.72]) expect(2 * size ** dustDimension(size)).toBeCloseTo(1, 12);
});
