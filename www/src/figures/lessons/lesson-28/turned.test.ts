import { expect, it } from "vitest";
import type { MapRow3 } from "#wasm/api";
import { isTheSame, SHAPE, THIRD, turnBy, turnedMaps } from "./turned";

const point = (map: MapRow3, [x, y, z]: readonly [number, number, number]) =>
  [0, 1, 2].map((row) => {
    const [a = 0, b = 0, c = 0] = map.slice(3 * row, 3 * row + 3);
    return a * x + b * y + c * z + (map[9 + row] ?? 0);
  }) as [number, number, number];

it("does with the turned point what the old map did with the old one", () => {
  const bent: MapRow3 = [0.5, 0.1, 0, -0.2, 0.4, 0.3, 0, 0.1, 0.6, 0.3, -0.2, 0.7];
  for (const map of [...SHAPE, bent]) {
    const [turned = map] = turnedMaps([map], 37);
    const at = [0.3, -0.8, 0.5] as const;
    const moved = point(turnBy(37), point(map, at));
    for (const [i, x] of point(turned, point(turnBy(37), at)).entries())
      expect(x).toBeCloseTo(moved[i] ?? 0, 12);
  }
});

it("leaves what only shrinks as it is, and turns its shift", () => {
  for (const [i, map] of turnedMaps(SHAPE, 25).entries()) {
    expect(map.slice(0, 9).map((x) => Math.round(1e9 * x) / 1e9 + 0)).toEqual([
      0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5,
    ]);
    expect(Math.hypot(...map.slice(9))).toBeCloseTo(Math.hypot(...(SHAPE[i]?.slice(9) ?? [])), 12);
  }
});

it("is the same shape again after a third of a turn, and not before", () => {
  const same = Array.from({ length: 360 }, (_, degrees) => degrees).filter((degrees) =>
    isTheSame(SHAPE, turnedMaps(SHAPE, degrees)),
  );
  expect(same).toEqual([0, THIRD, 2 * THIRD]);
});
