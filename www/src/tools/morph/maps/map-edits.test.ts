import { describe, expect, it } from "vitest";
import type { MapRow, Scene } from "#wasm/api";
import { rename, setMaps, setWeights } from "./map-edits";

const half: MapRow = [0.5, 0, 0, 0.5, 0, 0];
const right: MapRow = [0.5, 0, 0, 0.5, 0.5, 0];
const mirror: MapRow = [0.5, 0, 0, -0.5, 0, 0];
const third: MapRow = [0.3, 0, 0, 0.3, 0, 0];

const scene: Scene = {
  a: { preset: "one", name: "One", maps: [half, right, third], weights: [1, 2, 6] },
  b: { name: "Two", maps: [half, mirror, third] },
  mode: "polar",
  path: { kind: "auto", points: [] },
  t: 0,
  correspondence: [2, 0, 1],
  turns: [1, 0, -2],
  colouring: "map",
  compare: false,
};

describe("maps", () => {
  it("are out of the gallery once they are edited, and keep the pairs while their number stays", () => {
    const moved = setMaps(scene, "b", [half, mirror, half]);
    expect(moved.b).toEqual({ name: "Two", maps: [half, mirror, half] });
    expect(moved.correspondence).toEqual([2, 0, 1]);
    expect(setMaps(scene, "a", [half, half]).correspondence).toEqual([]);
    expect("preset" in setMaps(scene, "a", [half, half, half]).a).toBe(false);
  });
});

describe("weights", () => {
  it("stay with their maps, and a new map has the mean", () => {
    const weightsOf = (maps: MapRow[]) => setMaps(scene, "a", maps).a.weights;
    expect(weightsOf([half, mirror, third])).toEqual([1, 2, 6]);
    expect(weightsOf([half, third])).toEqual([1, 6]);
    expect(weightsOf([half, right, third, mirror])).toEqual([1, 2, 6, 3]);
    expect(setMaps(scene, "b", [half, mirror]).b.weights).toBeUndefined();
  });

  it("go where all that is left is never taken", () => {
    const zero = setWeights(scene, "a", [0, 0, 1]);
    expect(setMaps(zero, "a", [half, right]).a.weights).toBeUndefined();
  });

  it("leave the maps and their place in the gallery alone, and stay with a new name", () => {
    const weighed = setWeights(scene, "a", [1, 1, 1]);
    expect(weighed.a).toEqual({ ...scene.a, weights: [1, 1, 1] });
    expect(weighed.a.maps).toBe(scene.a.maps);
    expect(rename(weighed, "a", "Mine").a).toEqual({ name: "Mine", maps: scene.a.maps, weights: [1, 1, 1] });
    expect("weights" in setWeights(weighed, "a", undefined).a).toBe(false);
  });
});
