import { expect, test } from "vitest";
import { pathOf } from "./OutlinePanel";

test("an outline of any size stands in the middle of its picture, upright", () => {
  const flat = Float64Array.of(1000, -5, 1040, -5, 1040, 15, 1000, 15);
  expect(pathOf(flat, 100)).toBe("M0.0 75.0L100.0 75.0L100.0 25.0L0.0 25.0Z");
  expect(pathOf(Float64Array.of(3, 3, 3, 3), 100)).toBe("");
  expect(pathOf(new Float64Array(0), 100)).toBe("");
});

test("one of many points is drawn with few", () => {
  const ring = Float64Array.from({ length: 20_000 }, (_, i) => (i % 2 ? Math.sin(i) : Math.cos(i)));
  expect(pathOf(ring, 100).split("L").length).toBe(200);
});
