import { describe, expect, it } from "vitest";
import { sameWeighted, withWeights } from "#geometry/maps/weighted";
import type { MapRow, Route, Scene } from "#wasm/api";
import { asBoth, choose, flatPairs, MOST_POINTS, setPoints, swap, turnedFurther } from "./edits";
import { isMatched, takeMatching, takeRoute, takeWay } from "./ways";

const half: MapRow = [0.5, 0, 0, 0.5, 0, 0];
const mirror: MapRow = [0.5, 0, 0, -0.5, 0, 0];
const flat: MapRow = [0, 0, 0, 0.16, 0, 0];

const scene: Scene = {
  a: { preset: "one", name: "One", maps: [half, half, half] },
  b: { name: "Two", maps: [half, mirror, half] },
  mode: "polar",
  path: {
    kind: "drawn",
    points: [
      [0.1, 0.5],
      [0.7, 1.5],
    ],
  },
  t: 0.25,
  correspondence: [2, 0, 1],
  turns: [1, 0, -2],
  colouring: "map",
  compare: false,
};

describe("shapes", () => {
  it("asks anew which map becomes which when a shape is chosen", () => {
    const next = choose(scene, "b", { preset: "three", name: "Three", maps: [half] });
    expect(next.b).toEqual({ preset: "three", name: "Three", maps: [half] });
    expect(next.correspondence).toEqual([]);
    expect(next.turns).toEqual([]);
    expect(next.a).toBe(scene.a);
  });
  it("copies an end to the other", () => {
    expect(asBoth(scene, "a").b).toEqual(scene.a);
    expect(asBoth(scene, "b").a).toEqual(scene.b);
  });
});

describe("turns", () => {
  it("are added, and none are an empty list", () => {
    expect(turnedFurther(scene, [0, 1, 0]).turns).toEqual([1, 1, -2]);
    expect(turnedFurther(scene, [-1, 0, 2]).turns).toEqual([]);
    expect(turnedFurther({ ...scene, turns: [] }, [0, -1, 0]).turns).toEqual([0, -1, 0]);
  });
});

describe("swap", () => {
  it("runs the same morph backwards", () => {
    const back = swap(scene);
    expect(back.a).toBe(scene.b);
    expect(back.t).toBe(0.75);
    expect(back.path.points[0]?.[0]).toBeCloseTo(0.3, 12);
    expect(back.path.points[0]?.[1]).toBeCloseTo(-0.5, 12);
    // Map 1 became map 3 with one turn: now 3 becomes 1 with one turn the other way.
    expect(back.correspondence).toEqual([1, 2, 0]);
    expect(back.turns).toEqual([0, 2, -1]);
  });
  it("is its own inverse", () => {
    const twice = swap(swap(scene));
    expect(twice.correspondence).toEqual(scene.correspondence);
    expect(twice.turns).toEqual(scene.turns);
    expect(twice.t).toBe(scene.t);
    twice.path.points.forEach((p, i) => {
      expect(p[0]).toBeCloseTo(scene.path.points[i]?.[0] ?? Number.NaN, 12);
    });
  });
});

describe("setPoints", () => {
  it("makes the path a drawn one, of no more points than a link holds", () => {
    const many = Array.from({ length: 100 }, (): [number, number] => [0, 0]);
    const next = setPoints({ ...scene, path: { kind: "auto", points: [] } }, many);
    expect(next.path.kind).toBe("drawn");
    expect(next.path.points).toHaveLength(MOST_POINTS);
  });
});

describe("flatPairs", () => {
  it("names the pairs that reflect oppositely, by number from 1", () => {
    expect(flatPairs([half, half, half], [half, mirror, half], [])).toEqual([2]);
    expect(flatPairs([half, half, half], [half, mirror, half], [1, 0, 2])).toEqual([1]);
    expect(flatPairs([mirror], [mirror], [])).toEqual([]);
  });
  it("leaves out maps that are flat already, and lists of other lengths", () => {
    expect(flatPairs([flat, mirror], [mirror], [])).toEqual([]);
  });
});

describe("ways to match and ways across", () => {
  it("takes a way to match with its path, and leaves out what is so anyway", () => {
    const next = takeMatching(scene, { correspondence: [0, 1, 2], turns: [0, 1, 0] }, [[0.5, 0.5, 0.25]]);
    expect(next).toMatchObject({ correspondence: [], turns: [0, 1, 0] });
    expect(next.path).toEqual({ kind: "auto", points: [[0.5, 0.5, 0.25]] });
    expect(next.a).toBe(scene.a);
  });

  it("knows the way to match that is taken", () => {
    expect(isMatched(scene, { correspondence: [2, 0, 1], turns: [1, 0, -2] })).toBe(true);
    expect(isMatched(scene, { correspondence: [2, 0, 1], turns: [0, 0, 0] })).toBe(false);
    expect(isMatched({ correspondence: [], turns: [] }, { correspondence: [0, 1], turns: [0, 0] })).toBe(
      true,
    );
  });

  it("keeps the names on a way across, and the gallery only while its maps stand", () => {
    const same = scene.a.maps.map((row): MapRow => [...row]);
    const route = {
      kind: "mirror" as const,
      about: "",
      fromProbabilities: [0.5, 0.25, 0.25],
      toProbabilities: [0.5, 0.25, 0.25],
      correspondence: [0, 1, 2],
      turns: [0, 0, 0],
      cost: 1,
    };
    const next = takeRoute(scene, { ...route, from: same, to: [mirror, mirror, half] });
    expect(next.a).toBe(scene.a);
    expect(next.b).toEqual({ name: "Two", maps: [mirror, mirror, half] });
    expect(takeRoute(scene, { ...route, from: [half], to: [half] }).a).toEqual({ name: "One", maps: [half] });
    expect(next).toMatchObject({ correspondence: [], turns: [], path: { kind: "auto", points: [] } });
  });

  it("keeps weights on a way across, in other maps as those of their pieces, and gives none where there were none", () => {
    const weights = [1, 85, 14];
    const heavy: Scene = { ...scene, a: { ...scene.a, weights }, b: { ...scene.b } };
    const route: Route = {
      kind: "refine",
      about: "",
      from: [mirror, half, half, half, half],
      to: [half, mirror, mirror, half, half],
      fromProbabilities: [0.01, 0.14, 0.85 * 0.01, 0.85 * 0.85, 0.85 * 0.14],
      toProbabilities: [0.2, 0.2, 0.2, 0.2, 0.2],
      correspondence: [0, 1, 2, 3, 4],
      turns: [0, 0, 0, 0, 0],
      cost: 1,
    };
    const next = takeRoute(heavy, route);
    expect(next.a).toEqual({ name: "One", maps: route.from, weights: [1, 14, 0.85, 72.25, 11.9] });
    expect("weights" in next.b).toBe(false);
    expect(takeWay(heavy, route, []).a.weights).toEqual(next.a.weights);
    // Where the maps stay, so do the numbers that were typed.
    const stays = takeRoute(heavy, { ...route, from: heavy.a.maps, fromProbabilities: [0.3, 0.3, 0.4] });
    expect(stays.a).toBe(heavy.a);
    // Rounding makes no other shape of it, another weight does.
    expect(sameWeighted(next.a, { ...next.a, weights: [1, 14, 0.85, 72.25 + 1e-11, 11.9] })).toBe(true);
    for (const other of [undefined, [1, 14, 0.85, 72, 11.9], [1, 14, 0.85, 72.25]]) {
      expect(sameWeighted(next.a, withWeights(next.a, other))).toBe(false);
      expect(sameWeighted(withWeights(next.a, other), next.a)).toBe(false);
    }
  });

  it("takes a way that was found with its mode, its path and its maps, and what it leaves as it is", () => {
    const place: MapRow[] = [half, half, mirror];
    const way: Route = {
      kind: "place",
      about: "",
      from: scene.a.maps,
      to: place,
      fromProbabilities: [0.5, 0.25, 0.25],
      toProbabilities: [0.5, 0.25, 0.25],
      correspondence: [0, 2, 1],
      turns: [0, 0, 0],
      cost: 1,
    };
    const next = takeWay(scene, way, [[0.2, 0.4]]);
    expect(next).toMatchObject({ correspondence: [0, 2, 1], turns: [], mode: "polar", t: 0.25 });
    expect(next.a).toBe(scene.a);
    expect(next.b).toEqual({ name: "Two", maps: place });
    expect(next.path).toEqual({ kind: "auto", points: [[0.2, 0.4]] });
    const joints = takeWay(scene, { ...way, kind: "joints", mode: "linear" }, [[0.2, 0.4]]);
    expect(joints).toMatchObject({ mode: "linear", path: { kind: "straight", points: [] } });
    // The third parameter alone changes nothing but the path.
    expect(takeWay(scene, null, [[0.2, 0.4, 0.1]])).toEqual({
      ...scene,
      path: { kind: "auto", points: [[0.2, 0.4, 0.1]] },
    });
  });
});
