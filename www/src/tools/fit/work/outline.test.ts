import { expect, test } from "vitest";
import type { Curve } from "#wasm/api";
import { reached, sameCurve } from "./outline";

const curve = (x: number): Curve => ({
  knots: [
    [x, 0],
    [1, 0],
    [0, 1],
  ],
  edges: [null, null, null],
});

test("curves are the same by their numbers", () => {
  expect(sameCurve(curve(0), curve(0))).toBe(true);
  expect(sameCurve(curve(0), curve(0.5))).toBe(false);
});

test("a step of progress that brings the same curve changes nothing", () => {
  const of = {};
  const first = { of, numbers: 12, curve: curve(0) };
  expect(reached(null, first)).toBe(first);
  expect(reached(first, { of, numbers: 12, curve: curve(0) })).toBe(first);
  for (const next of [
    { of, numbers: 12, curve: curve(0.5) },
    { of, numbers: 14, curve: curve(0) },
    { of: {}, numbers: 12, curve: curve(0) },
  ]) {
    expect(reached(first, next)).toBe(next);
  }
});
