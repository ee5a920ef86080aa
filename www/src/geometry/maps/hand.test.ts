import { expect, test } from "vitest";
import type { MapRow3 } from "#wasm/api";
import { apply3, determinant3 } from "./affine3";
import { AT_REST, fromSlider, type Kind, nearlySame, stepOf, toSlider, transformOf } from "./hand";
import { inPlane } from "./row";

const IDENTITY: MapRow3 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

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

test("the same in the plane", () => {
  const turned = inPlane(transformOf("turn", { z: 90 }, [1, 0, 0])).map((x) => Number(x.toFixed(9)) || 0);
  expect(turned).toEqual([0, -1, 1, 0, 1, -1]);
  expect(inPlane(transformOf("move", { x: 1, y: -2 }, [9, 9, 0]))).toEqual([1, 0, 0, 1, 1, -2]);
  expect(inPlane(transformOf("scale", { all: 2, y: 3 }, [1, 1, 0]))).toEqual([2, 0, 0, 6, -1, -5]);
  expect(inPlane(transformOf("shear", { xy: 0.5, yx: 0.25 }, [0, 0, 0]))).toEqual([1, 0.5, 0.25, 1, 0, 0]);
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
