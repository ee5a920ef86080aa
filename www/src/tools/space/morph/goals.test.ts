import { describe, expect, it } from "vitest";
import type { MapRow3, Preset3 } from "#wasm/api";
import { goalsOf, ITSELF, missingWords } from "./goals";

const half = (x: number): MapRow3 => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, x, 0, 0];
const preset = (id: string, ...at: number[]): Preset3 => ({ id, name: id, about: "", maps: at.map(half) });
const presets = [preset("pair", 0, 1), preset("far", 0, 9), preset("three", 0, 1, 2)];

describe("what the first object can become", () => {
  it("is what has as many maps, and is not it already", () => {
    const ids = goalsOf([{ name: "pair", maps: [half(0), half(1)] }], presets).map(({ id }) => id);
    expect(ids).toEqual(["far", ITSELF]);
  });

  it("holds other objects once", () => {
    const own = { name: "own", maps: [half(3), half(4)] };
    const far = { preset: "far", name: "far", maps: [half(0), half(9)] };
    const goals = goalsOf([{ name: "pair", maps: [half(0), half(1)] }, own, own, far], presets);
    expect(goals.map(({ id }) => id)).toEqual(["far", "object-1", ITSELF]);
    expect(goals[1]?.shape).toEqual(own);
  });

  it("is at least a copy", () => {
    const goals = goalsOf([{ preset: "x", name: "x", maps: [half(7)], tint: "#123456" }], presets);
    expect(goals).toHaveLength(1);
    expect(goals[0]?.shape).toEqual({ preset: "x", name: "x", maps: [half(7)] });
    expect(goalsOf([], presets)).toEqual([]);
  });
});

describe("what cannot be chosen", () => {
  it("says why, by numbers", () => {
    expect(missingWords(2, presets, "Pair")).toBe(
      "Pair has 2 maps. Each map becomes a map, so you cannot choose a shape with 3 maps.",
    );
    expect(missingWords(1, presets, "Point")).toContain("has 1 map, and no other shape in the gallery");
    expect(missingWords(1, presets, "Point")).toContain("2 or 3 maps");
  });
});
