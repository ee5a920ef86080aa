import { expect, it, vi } from "vitest";
import type { MapRow } from "#wasm/api";

vi.mock("#wasm/core", () => ({ frond: {} }));
const { ranksIn, selection, shownColours } = await import("./morph");
const { scene, start } = await import("./scene");
const { ranked } = await import("./colours");

const [p, q, r]: [MapRow, MapRow, MapRow] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, 0.5],
];

it("gives each map of an end the place that it has in the morph", () => {
  // match=2,3,1: the first map of A becomes the second of B.
  expect(ranksIn([p, q, r], [p, q, r], [1, 2, 0])).toEqual([2, 0, 1]);
  expect(ranksIn([p, q], [q, p, p])).toEqual([1, 0]);
  expect(ranksIn([p, p, q], [p, p, q])).toEqual([0, 1, 2]);
});

it("leaves maps in their own order where they are not what is paired", () => {
  expect(ranksIn([p, q], [p, r, r])).toEqual([0, 1]);
  // All are there, and so is a piece that none of them makes.
  expect(ranksIn([p, q], [q, p, r])).toEqual([0, 1]);
  expect(ranksIn([p, q], [p, q], [0, 5])).toEqual([0, 1]);
});

it("gives maps the colours of their places", () => {
  const colours = ["red", "green", "blue"];
  expect(ranked(colours, [2, 0, 1])).toEqual(["blue", "red", "green"]);
  expect(ranked(colours, [0, 1])).toBe(colours);
  expect(ranked(colours, [4, 0])).toEqual(["green", "red"]);
});

it("shows a shape that is edited in the colours of the morph, whoever asks for them", () => {
  const maps = [p, q, r];
  const own = ["#ff0000", "#00ff00", "#0000ff"];
  const before = scene.peek();
  const ends = { a: { name: "A", maps }, b: { name: "B", maps: [...maps] } };
  start({ ...before, ...ends, correspondence: [1, 2, 0], palette: own });
  expect(shownColours("light")).toEqual(own);
  selection.value = { target: "a", map: 0 };
  expect(shownColours("dark")).toEqual(own);
  selection.value = { target: "b", map: 0 };
  expect(shownColours("light")).toEqual(["#0000ff", "#ff0000", "#00ff00"]);
  selection.value = null;
  start(before);
});
