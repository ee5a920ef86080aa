import { beforeEach, expect, test, vi } from "vitest";
import { notices } from "#document/notice";
import { edit, redo, scene, start, undo } from "#document/scene";
import type { MapRow, Scene } from "#wasm/api";
import { intoMorph, intoStates, withStates, withSystem } from "./morph";

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

test("colours of a file come with A, and go with it", () => {
  const coloured = { ...system, colours: ["#ff0000", "#00ff00"] };
  const after = withSystem(before, coloured, "a");
  expect(after.palette).toEqual(coloured.colours);
  expect(withSystem(before, coloured, "both").palette).toEqual(coloured.colours);
  expect("palette" in withSystem(before, coloured, "b")).toBe(false);
  expect(withSystem(after, system, "b").palette).toEqual(coloured.colours);
  expect("palette" in withSystem(after, system, "a")).toBe(false);
});

const ends = () => [scene.peek().a.name, scene.peek().b.name];
const asB = () => notices.peek().at(-1)?.action?.run();

beforeEach(() => start(before));

test("as B instead is one step, and undo brings back what was there before the file", async () => {
  await intoMorph(system, "a", "");
  expect(ends()).toEqual(["Mine", "tree"]);
  asB();
  await Promise.resolve();
  expect(ends()).toEqual(["fern", "Mine"]);
  undo();
  expect(ends()).toEqual(["fern", "tree"]);
  redo();
  expect(ends()).toEqual(["fern", "Mine"]);
});

test("as B instead keeps what was done since", async () => {
  await intoMorph(system, "a", "");
  edit((now) => ({ ...now, compare: true }));
  asB();
  await Promise.resolve();
  expect([...ends(), scene.peek().compare]).toEqual(["fern", "Mine", true]);
  undo();
  expect([...ends(), scene.peek().compare]).toEqual(["Mine", "tree", true]);
});

const graph = {
  name: "Graph",
  states: [
    [{ from: 1, map: HALF }],
    [
      { from: 0, map: HALF },
      { from: 1, map: HALF },
    ],
  ],
};

test.each([
  ["a", 0, "Graph", "tree"],
  ["b", 1, "fern", "Graph"],
  ["both", 0, "Graph", "Graph"],
] as const)("a graph-directed shape of a file is seen where it was put: %s", (where, t, a, b) => {
  const after = withStates(before, graph, where);
  expect([after.directed?.a.name, after.directed?.b.name]).toEqual([a, b]);
  expect([after.t, after.tool]).toEqual([t, "morph"]);
  expect((where === "b" ? after.directed?.b : after.directed?.a)?.states).toEqual(graph.states);
});

test("a graph-directed shape as B instead is one step, and its states and maps are counted", () => {
  intoStates(graph, "a", "Said.");
  expect(notices.peek().at(-1)?.text).toBe("Graph is now shape A, with 3 maps in 2 states. Said.");
  asB();
  expect([scene.peek().directed?.a.name, scene.peek().directed?.b.name]).toEqual(["fern", "Graph"]);
  undo();
  expect(scene.peek()).toEqual(before);
});
