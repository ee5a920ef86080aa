import { expect, test } from "vitest";
import type { MapRow3, SpaceView } from "#wasm/api";
import { axesOf, dotsOf, fromOrigin, orbited, seen } from "./eye";

const view: SpaceView = { target: [1, 2, 3], distance: 5, turn: 0, tilt: 0, angle: Math.PI / 2 };
const round = (list: readonly number[]) => list.map((x) => Math.round(x * 1e9) / 1e9 + 0);

test("turn 0 looks along y", () => {
  expect(round(axesOf(view).eye)).toEqual([1, -3, 3]);
  expect(round(seen(view)([1, 2, 3]))).toEqual([0, 0, 5]);
  expect(round(seen(view)([6, 2, 8]))).toEqual([1, 1, 5]);
});

test("turning goes about the target, or about the eye that is held", () => {
  const about = orbited(view, Math.PI / 2, 0.2);
  expect(about.target).toEqual(view.target);
  expect(round(seen(about)(view.target))).toEqual([0, 0, 5]);
  const held = orbited({ ...view, holds: "eye" }, Math.PI / 2, 0.2);
  expect(round(axesOf(held).eye)).toEqual([1, -3, 3]);
  expect(orbited(view, 0, 9).tilt).toBeCloseTo(Math.PI / 2, 12);
  expect(orbited(view, 2 * Math.PI, 0).turn).toBeCloseTo(0, 12);
});

test("the eye of the paper is at the origin", () => {
  const far = fromOrigin([15, -2, 1], 0.5);
  expect(round(axesOf(far).eye)).toEqual([0, 0, 0]);
  expect(round(seen(far)([15, -2, 1]).slice(0, 2))).toEqual([0, 0]);
});

test("points are on the attractor", () => {
  const half = (x: number): MapRow3 => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, x, 0, 0];
  const dots = dotsOf([half(0), half(0.5)], 500);
  expect(dots).toHaveLength(500);
  for (const { point, map } of dots) {
    expect(point[0]).toBeGreaterThanOrEqual(map / 2 - 1e-9);
    expect(point[0]).toBeLessThanOrEqual((map + 1) / 2 + 1e-9);
  }
});

test("large pieces get more points, and flat ones some", () => {
  const maps: MapRow3[] = [
    [0.8, 0, 0, 0, 0.8, 0, 0, 0, 0.8, 0, 0, 0],
    [0.4, 0, 0, 0, 0.4, 0, 0, 0, 0.4, 1, 0, 0],
    [0.4, 0, 0, 0, 0, 0, 0, 0, 0.4, 0, 1, 0],
  ];
  const counts = [0, 1, 2].map((map) => dotsOf(maps, 4000).filter((dot) => dot.map === map).length);
  expect(counts[0]).toBeGreaterThan(5 * (counts[1] ?? 0));
  expect(counts[1]).toBeGreaterThan(2 * (counts[2] ?? 0));
  expect(counts[2]).toBeGreaterThan(20);
});
