import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Shape } from "#wasm/api";

const HALF: Shape = { preset: "half", name: "Half", maps: [[0.5, 0, 0, 0.5, 0, 0]] };
let storage: Map<string, string>;
let isFull: boolean;

beforeEach(() => {
  storage = new Map();
  isFull = false;
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => storage.get(key) ?? null,
    setItem: (key: string, text: string) => {
      if (isFull) throw new DOMException("full", "QuotaExceededError");
      storage.set(key, text);
    },
  });
  vi.resetModules();
});
afterEach(() => vi.unstubAllGlobals());

const opened = () => import("./own-shapes");

it("keeps shapes, the latest first, over a new visit", async () => {
  const { keepShape } = await opened();
  expect(keepShape(HALF)).toBeNull();
  expect(keepShape({ ...HALF, name: "Other" })).toBeNull();
  vi.resetModules();
  const { ownShapes } = await opened();
  expect(ownShapes.value.map(({ name }) => name)).toEqual(["Other", "Half"]);
  expect(ownShapes.value[1]?.maps).toEqual(HALF.maps);
});

it("renames and removes the one that is meant", async () => {
  const { keepShape, ownShapes, renameOwnShape, removeOwnShape } = await opened();
  keepShape(HALF);
  keepShape(HALF);
  const [first, second] = ownShapes.value;
  expect(renameOwnShape(second?.id ?? "", "  Mine  ")).toBeNull();
  expect(ownShapes.value.map(({ name }) => name)).toEqual(["Half", "Mine"]);
  expect(renameOwnShape(second?.id ?? "", " ")).toMatch(/name/);
  removeOwnShape(first?.id ?? "");
  expect(ownShapes.value.map(({ name }) => name)).toEqual(["Mine"]);
});

it("keeps shapes of several states, and none that are no such", async () => {
  const { keepDirected, ownShapes, readShapes } = await opened();
  const half = (from: number) => ({ from, map: HALF.maps[0] as (typeof HALF.maps)[number] });
  const states = [[half(1), half(0)], [half(1)]];
  expect(keepDirected({ preset: "twins", name: "Twins", states, outline: "Af3" })).toBeNull();
  const [kept] = ownShapes.value;
  expect(kept).toMatchObject({ name: "Twins", maps: [], states, outline: "Af3" });
  expect(readShapes(JSON.stringify(ownShapes.value))).toEqual(ownShapes.value);
  for (const wrong of [[], [[]], [[half(2)], [half(0)]], [[{ from: 0, map: [1] }]]])
    expect(readShapes(JSON.stringify([{ ...kept, states: wrong }]))).toEqual([]);
});

it("says so where there is no room, and has the shape all the same", async () => {
  const { keepShape, ownShapes } = await opened();
  isFull = true;
  expect(keepShape(HALF)).toMatch(/when you close the page/);
  expect(ownShapes.value).toHaveLength(1);
});

it("keeps sixty and no more", async () => {
  const { keepShape, ownShapes } = await opened();
  for (let i = 0; i < 60; i++) expect(keepShape(HALF)).toBeNull();
  expect(keepShape(HALF)).toMatch(/Remove one/);
  expect(ownShapes.value).toHaveLength(60);
});

it("keeps the weights of a shape, and none that are no weights", async () => {
  const { keepShape, ownShapes, readShapes } = await opened();
  keepShape({ ...HALF, weights: [3] });
  expect(ownShapes.value[0]?.weights).toEqual([3]);
  expect(readShapes([...storage.values()][0] ?? null)[0]?.weights).toEqual([3]);
  for (const weights of [[], [1, 2], [-1], [0], ["1"], 3, null])
    expect(readShapes(JSON.stringify([{ id: "a", name: "A", maps: HALF.maps, weights }]))).toEqual([
      { id: "a", name: "A", maps: HALF.maps },
    ]);
});

it("calls a copy by the next number that is free", async () => {
  const { copyName } = await opened();
  expect(copyName("Fern", new Set())).toBe("Fern 2");
  expect(copyName("Fern 2", new Set(["Fern", "Fern 2", "Fern 3"]))).toBe("Fern 4");
  expect(copyName("x".repeat(60), new Set())).toHaveLength(58);
});

it("passes over what is no shape", async () => {
  const { readShapes } = await opened();
  const good = { id: "a", name: "A", maps: HALF.maps };
  const bad = [
    null,
    1,
    {},
    { ...good, maps: [] },
    { ...good, maps: [[1, 2, 3]] },
    { ...good, maps: [[1, 2, 3, 4, 5, null]] },
    { ...good, maps: Array.from({ length: 65 }, () => HALF.maps[0]) },
    { ...good, name: 3 },
  ];
  expect(readShapes(JSON.stringify([...bad, good]))).toEqual([good]);
  for (const text of [null, "", "{", "{}", "3"]) expect(readShapes(text)).toEqual([]);
});
