/** A shape taken in hand as a whole: what becomes of the document, by the module that conjugates. */
import { readFile } from "node:fs/promises";
import { beforeAll, beforeEach, expect, it } from "vitest";
import { placeShape, takenOf } from "#document/editing/whole";
import { edit, endGesture, redo, scene, start, undo } from "#document/scene";
import { apartBy } from "#geometry/maps/apart";
import type { MapRow } from "#wasm/api";
import initCore from "../../www/pkg/frond-first.js";

const blank = { ...scene.peek() };
const first = { ...blank, a: { preset: "gasket", ...blank.a }, correspondence: [1, 2, 0] };
const TURNED: MapRow = [0, -2, 2, 0, 3, 1];

beforeAll(() =>
  initCore({ module_or_path: readFile(new URL("../../www/pkg/frond-first_bg.wasm", import.meta.url)) }),
);
beforeEach(() => start(first));

it("conjugates the maps, and keeps the rest", () => {
  placeShape("a", TURNED);
  const { a } = scene.peek();
  expect(scene.peek()).toEqual({ ...first, a });
  // w x = x / 2 becomes x / 2 + t / 2.
  expect(a.maps[0]).toEqual([0.5, 0, 0, 0.5, 1.5, 0.5]);
  expect(a.preset).toBeUndefined();
  expect(a.name).toBe(first.a.name);
  const apart = apartBy(first.a.maps, a.maps, TURNED);
  expect(apart.most / apart.size).toBeLessThan(1e-14);
});

it("starts from how it was taken each time, so that no rounding adds up", () => {
  for (let i = 1; i <= 1000; i++) {
    const [cos, sin] = [Math.cos(i), Math.sin(i)];
    placeShape("a", [cos, -sin, sin, cos, i / 7, 0], { gesture: "turn" });
  }
  endGesture();
  const { made, moved } = takenOf(scene.peek().a);
  expect(made).toBe(first.a);
  const apart = apartBy(made.maps, scene.peek().a.maps, moved);
  expect(apart.most / apart.size).toBeLessThan(1e-13);
  // Back where it was, it is what it was, preset and all.
  placeShape("a", null);
  expect(scene.peek().a).toBe(first.a);
});

it("is one step of undo a gesture, and comes back with what was done to it", () => {
  placeShape("a", [2, 0, 0, 2, 0, 0], { gesture: "hand" });
  placeShape("a", TURNED, { gesture: "hand" });
  endGesture();
  undo();
  expect(scene.peek().a).toBe(first.a);
  expect(takenOf(scene.peek().a).moved).toEqual([1, 0, 0, 1, 0, 0]);
  redo();
  expect(takenOf(scene.peek().a)).toEqual({ made: first.a, moved: TURNED });
});

it("is taken anew where its maps were edited since", () => {
  placeShape("a", TURNED);
  const { a } = scene.peek();
  edit((now) => ({ ...now, a: { ...a, maps: a.maps.toReversed() } }));
  expect(takenOf(scene.peek().a)).toEqual({ made: scene.peek().a, moved: [1, 0, 0, 1, 0, 0] });
});

it.each([
  ["flat", [1, 1, 1, 1, 0, 0]],
  ["flattened to a point", [0, 0, 0, 0, 1, 1]],
  ["out of all bounds", [1e300, 0, 0, 1e-300, 1e300, 0]],
  ["no number", [Number.NaN, 0, 0, 1, 0, 0]],
  ["infinite", [1, 0, 0, 1, Number.POSITIVE_INFINITY, 0]],
] as [string, MapRow][])("refuses what is %s, and stays", (_, by) => {
  expect(() => placeShape("a", by)).toThrow(
    expect.objectContaining({ message: expect.stringMatching(/\w+\./) }),
  );
  expect(scene.peek()).toBe(first);
});
