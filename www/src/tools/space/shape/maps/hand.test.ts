import { expect, test } from "vitest";
import { IDENTITY } from "#document/space/space";
import { apply3, determinant3 } from "#geometry/maps/affine3";
import { AT_REST, fromSlider, type Kind, nearlySame, stepOf, toSlider, transformOf } from "./hand";

test("at rest nothing is done", () => {
  for (const kind of Object.keys(AT_REST) as Kind[]) {
    expect(nearlySame(transformOf(kind, AT_REST[kind], [3, 1, -2]), IDENTITY)).toBe(true);
  }
});

test("degrees, lengths, factors and slides", () => {
  const [x, y, z] = apply3(transformOf("turn", { z: 90 }, [1, 0, 0]), [2, 0, 5]);
  expect([x, y, z].map((at) => Number(at.toFixed(9)))).toEqual([1, 1, 5]);
  expect(apply3(transformOf("move", { x: 1, z: -2 }, [9, 9, 9]), [1, 1, 1])).toEqual([2, 1, -1]);
  expect(determinant3(transformOf("scale", { all: 2, y: 3 }, [1, 1, 1]))).toBe(24);
  expect(apply3(transformOf("shear", { xz: 0.5 }, [0, 0, 1]), [0, 0, 3])).toEqual([1, 0, 3]);
});

test("rounding is no change", () => {
  const far = transformOf("move", { x: 1000 }, [0, 0, 0]);
  expect(nearlySame(far, far.map((x) => x * (1 + 1e-9)) as typeof far)).toBe(true);
  expect(nearlySame(IDENTITY, transformOf("move", { x: 1e-5 }, [0, 0, 0]))).toBe(false);
});

test("steps and factors are round", () => {
  expect([1, 3, 0.02, 1500].map((reach) => Number(stepOf(reach).toPrecision(6)))).toEqual([
    0.01, 0.02, 0.0002, 20,
  ]);
  expect(fromSlider(toSlider(2))).toBe(2);
  expect(toSlider(1e9)).toBe(4);
  expect(fromSlider(0.5)).toBe(1.41);
});
