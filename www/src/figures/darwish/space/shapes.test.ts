import { expect, test } from "vitest";
import { apply3, scale3, turns3 } from "#geometry/maps/affine3";
import { apartBy } from "#geometry/maps/apart";
import { dotsOf } from "./eye";
import { pyramid, triangle } from "./shapes";

test("both forms of the triangle are one picture, in the plane z = 0", () => {
  const [halves, sheet] = [triangle("halves"), triangle("sheet")];
  expect(apartBy(halves, sheet, scale3([1, 1, 1])).most).toBeLessThan(1e-12);
  for (const { point } of dotsOf(halves, 200)) expect(Math.abs(point[2])).toBeLessThan(1e-12);
});

test("a half is the same from all sides, a sheet is not", () => {
  const turn = turns3([0.3, 0.5, 0.9]);
  const [a, b, c, d, e, f, g, h, i] = turn;
  const back = [a, d, g, b, e, h, c, f, i, 0, 0, 0] as typeof turn;
  const columns = (["halves", "sheet"] as const).map((form) => {
    const map = triangle(form)[0] ?? turn;
    const unit = apply3(map, apply3(back, [0, 0, 1])).map((x, k) => x - (map[9 + k] ?? 0));
    return apply3(turn, unit as [number, number, number]).map((x) => Number(x.toFixed(9)) + 0);
  });
  expect(columns[0]).toEqual([0, 0, 0.5]);
  expect(columns[1]).not.toEqual([0, 0, 0.5]);
});

test("the pyramid stands where it is put: half of its corners are its translations", () => {
  const maps = pyramid([30, 0, 0]);
  expect(maps).toHaveLength(5);
  expect(maps.map((map) => map[9])).toEqual([14.8, 14.8, 15.2, 15.2, 15]);
  expect(maps[4]).toEqual([0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 15, 0, 0.2]);
});
