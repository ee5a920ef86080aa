import { expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { determinant } from "../../kit/maps/families";
import { flagPath, leastScale, stopHolds, turned } from "./flag";

it("turns without changing sizes", () => {
  for (const angle of [0, 1, Math.PI, -2]) expect(determinant(turned(angle, 0.5))).toBeCloseTo(0.25, 12);
});

it("draws the letter upright, and a single point where the map is nothing", () => {
  expect(flagPath([1, 0, 0, 1, 0, 0], 10)).toMatch(/^M-6\.00 10\.00L-6\.00 -10\.00L7\.00 -10\.00/);
  const nothing = flagPath([0, 0, 0, 0, 0, 0], 10).replace(/-0/g, "0");
  expect(new Set(nothing.slice(1, -1).split("L"))).toEqual(new Set(["0.00 0.00"]));
});

it("is smallest half-way between two turns", () => {
  for (const angle of [0, 0.7, Math.PI / 2, 2.5, Math.PI]) {
    const [from, to] = [turned(angle, 0.5), turned(0, 0.5)];
    const blend = (t: number) => from.map((x, i) => (1 - t) * x + t * (to[i] ?? 0)) as MapRow;
    const scales = [0, 0.25, 0.5, 0.75, 1].map((t) => Math.sqrt(determinant(blend(t))) / 0.5);
    expect(leastScale(angle)).toBeCloseTo(scales[2] ?? 0, 12);
    for (const scale of scales) expect(scale).toBeGreaterThanOrEqual(leastScale(angle) - 1e-12);
  }
});

it("holds with a stop near the middle of a half turn only", () => {
  expect([60, 88, 89, 90, 91, 92, 180].filter(stopHolds)).toEqual([89, 90, 91]);
});
