import { beforeEach, expect, test } from "vitest";
import type { CurvePreset, CurveShape } from "#wasm/api";
import { useCurve } from "./fit";
import { scene, start, undo } from "./scene";
import { tool } from "./tool";

const blank = { ...scene.peek() };
const curve = { knots: [], edges: [] };
const shape = (name: string): CurveShape => ({ name, curve });
const partner = { id: "maple", name: "Maple", curve } as unknown as CurvePreset;

beforeEach(() => start(blank));

test("one fit becomes A and another B, each seen at its end, and what is there stays", () => {
  useCurve(shape("mine"), partner, "a");
  expect([scene.value.curves?.a.name, scene.value.curves?.b.name]).toEqual(["mine", "Maple"]);
  expect([scene.value.t, tool.value]).toEqual([0, "morph"]);
  useCurve(shape("other"), partner, "b");
  expect([scene.value.curves?.a.name, scene.value.curves?.b.name]).toEqual(["mine", "other"]);
  expect(scene.value.t).toBe(1);
  undo();
  expect(scene.value.curves?.b.name).toBe("Maple");
});

test("what is bent is the first shape, under the grid", () => {
  useCurve(shape("mine"), partner, "bent");
  expect([scene.value.curves?.a.name, scene.value.t, tool.value]).toEqual(["mine", 0, "deform"]);
});
