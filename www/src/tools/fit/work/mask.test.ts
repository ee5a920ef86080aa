import { expect, test } from "vitest";
import type { Component } from "#workers/fit/trace-types";
import { sameComponent } from "./mask";

const at = (x0: number, y0: number, x1: number, y1: number): Component => ({
  area: (x1 - x0) * (y1 - y0),
  box: [x0, y0, x1, y1],
  at: [x0, y0],
  touchesBorder: false,
});

test("a part that was picked is found again when others come and go before it", () => {
  const picked = at(60, 60, 80, 80);
  expect(sameComponent([at(0, 0, 50, 50), at(61, 59, 81, 80)], picked, 2)).toBe(1);
  expect(sameComponent([at(0, 0, 50, 50), at(0, 60, 40, 90), at(61, 59, 81, 80)], picked, 1)).toBe(2);
  // Of a large one around it and one of its size it is the latter.
  expect(sameComponent([at(0, 0, 100, 100), at(59, 60, 80, 81)], picked, 1)).toBe(1);
});

test("what is gone gives way to the largest, and the largest stays the largest", () => {
  expect(sameComponent([at(0, 0, 10, 10)], at(60, 60, 80, 80), 3)).toBe(0);
  expect(sameComponent([at(0, 0, 90, 90), at(60, 60, 80, 80)], at(60, 60, 80, 80), 0)).toBe(0);
  expect(sameComponent([], at(0, 0, 1, 1), 1)).toBe(0);
});
