import { expect, it } from "vitest";
import type { DirectedShape } from "#wasm/api";
import { plantMayHelp } from "./outlines";

const fern: DirectedShape = { name: "Fern", states: [] };
const frond: DirectedShape = { preset: "frond", name: "Frond", states: [] };
const leaf: DirectedShape = { name: "Leaf", states: [], outline: "AbC" };

it("offers the plant that holds where another shape stands beside one outline", () => {
  expect(plantMayHelp({ a: fern, b: leaf })).toBe("b");
  expect(plantMayHelp({ a: leaf, b: fern })).toBe("a");
  for (const [a, b] of [
    [frond, leaf],
    [leaf, frond],
    [leaf, leaf],
    [fern, fern],
  ] as const)
    expect(plantMayHelp({ a, b })).toBeNull();
});
