import { expect, it } from "vitest";
import { determinant } from "../../kit/maps/families";
import { flagPath, turned } from "./flag";

it("turns without changing sizes", () => {
  for (const angle of [0, 1, Math.PI, -2]) expect(determinant(turned(angle, 0.5))).toBeCloseTo(0.25, 12);
});

it("draws the letter upright, and a single point where the map is nothing", () => {
  expect(flagPath([1, 0, 0, 1, 0, 0], 10)).toMatch(/^M-6\.00 10\.00L-6\.00 -10\.00L7\.00 -10\.00/);
  const nothing = flagPath([0, 0, 0, 0, 0, 0], 10).replace(/-0/g, "0");
  expect(new Set(nothing.slice(1, -1).split("L"))).toEqual(new Set(["0.00 0.00"]));
});
