import { expect, test } from "vitest";
import type { MapRow3, Point3 } from "#wasm/api";
import known from "../../../../tests/known/conjugation.json";
import { about3, after3, apply3, determinant3, scale3, shift3, turns3 } from "./affine3";

interface Case {
  linear: number[][];
  translation: number[];
  by_linear: number[][];
  by_translation: number[];
  result_linear: number[][];
  result_translation: number[];
}

const { cases } = known as { cases: Case[] };

const row = (linear: number[][], translation: number[]) => [...linear.flat(), ...translation] as MapRow3;

test("the conjugated map after the transform is the transform after the map", () => {
  const inSpace = cases.filter(({ translation }) => translation.length === 3);
  expect(inSpace.length).toBeGreaterThan(3);
  for (const one of inSpace) {
    const by = row(one.by_linear, one.by_translation);
    const left = after3(row(one.result_linear, one.result_translation), by);
    const right = after3(by, row(one.linear, one.translation));
    const size = Math.max(...right.map(Math.abs), 1);
    for (const [i, x] of left.entries()) expect(Math.abs(x - (right[i] ?? 0)) / size).toBeLessThan(1e-9);
  }
});

test("turns follow the right hand, x first", () => {
  const right = Math.PI / 2;
  const near = (p: Point3, q: Point3) =>
    p.forEach((x, i) => {
      expect(x).toBeCloseTo(q[i] ?? 0, 12);
    });
  near(apply3(turns3([right, 0, 0]), [0, 1, 0]), [0, 0, 1]);
  near(apply3(turns3([0, right, 0]), [0, 0, 1]), [1, 0, 0]);
  near(apply3(turns3([0, 0, right]), [1, 0, 0]), [0, 1, 0]);
  near(apply3(turns3([right, right, 0]), [0, 1, 0]), [1, 0, 0]);
  const all = turns3([0.3, -0.8, 2.1]);
  const oneByOne = after3(turns3([0, 0, 2.1]), after3(turns3([0, -0.8, 0]), turns3([0.3, 0, 0])));
  for (const [i, x] of all.entries()) expect(x).toBeCloseTo(oneByOne[i] ?? 0, 12);
  expect(determinant3(all)).toBeCloseTo(1, 12);
});

test("a centre stays where it is", () => {
  const centre: Point3 = [3, -1, 2];
  const [x, y, z] = apply3(about3(after3(turns3([0.4, 1, 0]), scale3([2, 3, 0.5])), centre), centre);
  expect([x, y, z].map((at) => Number(at.toFixed(12)))).toEqual(centre);
  expect(determinant3(scale3([2, 3, 0.5]))).toBe(3);
});

test("shifts add, and rows are compared number by number", () => {
  expect(after3(shift3([1, 2, 3]), shift3([3, 2, 1]))).toEqual(shift3([4, 4, 4]));
});
