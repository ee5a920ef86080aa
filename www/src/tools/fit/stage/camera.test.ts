import { expect, test } from "vitest";
import { between } from "./camera";

test("a glide begins and ends where it should, and what stays in place stays there all the way", () => {
  const from = { x: 1, y: 0, scale: 100 };
  const to = { x: 3, y: -1, scale: 400 };
  expect(between(from, to, 0)).toEqual(from);
  const end = between(from, to, 1);
  expect([end.x, end.y, end.scale].map((z) => z.toFixed(9))).toEqual([3, -1, 400].map((z) => z.toFixed(9)));
  // The one point that both views have at the same place of the stage.
  const fixed = (to.x * to.scale - from.x * from.scale) / (to.scale - from.scale);
  const at = (s: number) => {
    const v = between(from, to, s);
    return (fixed - v.x) * v.scale;
  };
  for (const s of [0.2, 0.5, 0.9]) expect(at(s)).toBeCloseTo(at(0), 6);
  expect(between(from, { ...from, x: 2 }, 0.5).x).toBeCloseTo(1.5, 9);
});
