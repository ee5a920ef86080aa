import { expect, test, vi } from "vitest";
import type { MapRow, Scene } from "#wasm/api";
import { withSystem } from "./morph";

vi.mock("#wasm/core", () => ({ frond: {} }));

const HALF: MapRow = [0.5, 0, 0, 0.5, 0, 0];
const shape = (name: string) => ({ preset: name, name, maps: [HALF] });
const before: Scene = {
  a: shape("fern"),
  b: shape("tree"),
  mode: "polar",
  path: { kind: "drawn", points: [[0.5, 0.2]] },
  t: 0.4,
  correspondence: [0],
  turns: [1],
  colouring: "map",
  compare: false,
  tool: "space",
  locus: { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 4, w: 0, at: [0.3, 0.3] },
};
const system = { name: "Mine", maps: [HALF, HALF] };

test.each([
  ["a", 0, "Mine", "tree"],
  ["b", 1, "fern", "Mine"],
  ["both", 0, "Mine", "Mine"],
] as const)("a system of a file is seen where it was put: %s", (where, t, a, b) => {
  const after = withSystem(before, system, where);
  expect([after.a.name, after.b.name, after.t, after.tool]).toEqual([a, b, t, "morph"]);
  const taken = where === "b" ? after.b : after.a;
  expect(taken).toEqual({ name: "Mine", maps: [HALF, HALF] });
  // Which map becomes which is asked anew, and what was looked at off the path is left.
  expect([after.correspondence, after.turns, after.locus?.at]).toEqual([[], [], undefined]);
  expect(after.path).toBe(before.path);
});
