import { describe, expect, it } from "vitest";
import { AT_REST } from "#document/deform/bend";
import type { Deformation, MapRow, Scene, Shape } from "#wasm/api";
import {
  choose,
  inBox,
  isAtRest,
  onPath,
  ratioOf,
  roughFrom,
  sameBox,
  withCorners,
  withDetail,
  withKey,
  withKeyAt,
  withLocality,
  withLoop,
  withoutKey,
} from "./deform-edits";

const still = (x: number) => new Array<number>(32).fill(x);
const four: Deformation = {
  ...AT_REST,
  keys: [0, 0.25, 0.5, 0.75].map((at, i) => ({ at, moves: still(i) })),
};

describe("choose", () => {
  const maps: MapRow[] = [[0.5, 0, 0, 0.5, 0, 0]];
  const one: Shape = { preset: "one", name: "One", maps };
  const scene: Scene = {
    a: { name: "A", maps },
    b: { name: "B", maps },
    mode: "polar",
    path: { kind: "auto", points: [] },
    t: 0.7,
    correspondence: [0],
    turns: [1],
    colouring: "map",
    compare: false,
    locus: { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 3, w: 0, at: [0.2, 0.4] },
  };

  it("shows that shape, with the mesh around it", () => {
    const bent = { ...four, subject: "picture" as const };
    const after = choose({ ...scene, deform: bent }, one, [0, 0, 2, 4]);
    expect(after).toMatchObject({ a: { preset: "one", name: "One" }, t: 0, correspondence: [], turns: [] });
    expect(after.locus?.at).toBeUndefined();
    expect(after.locus?.zoom).toBe(3);
    expect(after.deform).toMatchObject({ box: [0, 0, 2, 4], subject: "shape" });
    expect(after.b).toBe(scene.b);
  });

  it("adds no mesh where there is none yet", () => {
    expect(choose(scene, one, [0, 0, 2, 4]).deform).toBeUndefined();
  });

  it("leaves a polygon's plane for the path", () => {
    const polygon: Scene = {
      ...scene,
      locus: { ...scene.locus, family: "polygon" } as Scene["locus"] & object,
    };
    expect(onPath(polygon).locus).toBeUndefined();
    const { locus: _, ...plain } = scene;
    expect(onPath(plain)).toBe(plain);
  });
});

describe("inBox", () => {
  it("takes displacements along, each way by its own", () => {
    const wide = inBox(four, [5, 5, 15, 7]);
    expect(wide.keys[1]?.moves.slice(0, 4)).toEqual([10, 2, 10, 2]);
    expect(inBox(wide, [0, 0, 1, 1]).keys).toEqual(four.keys);
    expect(inBox(four, [0, 0, 1, 1])).toBe(four);
  });
});

describe("locality and detail", () => {
  it("never let kb pass ke, and keep what was wished for", () => {
    const bend = { ...AT_REST, kb: 5, ke: 9 };
    expect(withDetail(bend, 3.5, 5)).toMatchObject({ ke: 3.5, kb: 3.5 });
    expect(withDetail(withDetail(bend, 3.5, 5), 8, 5)).toMatchObject({ ke: 8, kb: 5 });
    expect(withLocality(bend, 12).kb).toBe(9);
    expect(withLocality(bend, -1).kb).toBe(0);
  });
});

describe("withCorners", () => {
  it("makes four of one, and their mean of four", () => {
    const apart = withCorners({ ...AT_REST, delta: 0.6 }, true);
    expect(apart.delta).toEqual([0.6, 0.6, 0.6, 0.6]);
    expect(withCorners({ ...apart, delta: [0, 0.2, 0.4, 1] }, false).delta).toBe(0.4);
    expect(withCorners(apart, true)).toBe(apart);
  });
});

describe("roughFrom", () => {
  it("is the largest stretch of any map", () => {
    const c = Math.cos(0.7) / 3;
    const s = Math.sin(0.7) / 3;
    expect(ratioOf([c, -s, s, c, 9, 9])).toBeCloseTo(1 / 3, 12);
    expect(ratioOf([0, 0, 0, 0, 1, 1])).toBe(0);
    expect(ratioOf([0, 0, 0, 0.16, 0, 0])).toBeCloseTo(0.16, 12);
    // A shear stretches more than its numbers say.
    expect(ratioOf([0.5, 0.5, 0, 0.5, 0, 0])).toBeCloseTo(0.809017, 5);
    expect(
      roughFrom([
        [0.5, 0, 0, 0.2, 0, 0],
        [0, 0.7, -0.7, 0, 1, 1],
      ]),
    ).toBeCloseTo(0.7, 12);
    expect(roughFrom([])).toBe(0);
  });
});

describe("keys", () => {
  it("stay in order when they are moved, and take the moment along", () => {
    const moved = withKeyAt(four, 1, 0.4);
    expect(moved.keys.map((key) => key.at)).toEqual([0, 0.4, 0.5, 0.75]);
    expect(moved.phase).toBe(0.4);
    expect(withKeyAt(four, 1, 9).keys[1]?.at).toBeLessThan(0.5);
    expect(withKeyAt(four, 1, -9).keys[1]?.at).toBeGreaterThan(0);
    expect(withKeyAt(four, 3, 9).keys[3]?.at).toBeLessThan(1);
    expect(withKeyAt({ ...four, loop: false }, 3, 9).keys[3]?.at).toBe(1);
    expect(withKeyAt(four, 0, -9).keys[0]?.at).toBe(0);
    expect(withKeyAt(four, 9, 0.5)).toBe(four);
    expect(withKeyAt(four, 1, Number.NaN)).toBe(four);
  });

  it("are added where there is none, up to their number", () => {
    const more = withKey(four, 0.6, still(9));
    expect(more.keys.map((key) => key.at)).toEqual([0, 0.25, 0.5, 0.6, 0.75]);
    expect(more.keys[3]?.moves).toEqual(still(9));
    expect(withKey(four, 0.5, still(9))).toBe(four);
    // The end of a loop is its start.
    expect(withKey(four, 1, still(9))).toBe(four);
    const full = { ...four, keys: Array.from({ length: 32 }, (_, i) => ({ at: i / 32, moves: still(0) })) };
    expect(withKey(full, 0.51, still(9))).toBe(full);
  });

  it("are deleted, but for the last", () => {
    expect(withoutKey(four, 2).keys.map((key) => key.at)).toEqual([0, 0.25, 0.75]);
    const one = { ...four, keys: four.keys.slice(0, 1) };
    expect(withoutKey(one, 0)).toBe(one);
    expect(withoutKey(four, 9)).toBe(four);
  });

  it("at the very end go to the start, or give way to it, once it loops", () => {
    const line = (ats: number[]): Deformation => ({
      ...AT_REST,
      loop: false,
      keys: ats.map((at) => ({ at, moves: still(at) })),
    });
    expect(withLoop(line([0, 0.5, 1]), true).keys.map((key) => key.at)).toEqual([0, 0.5]);
    expect(withLoop(line([0.5, 1]), true).keys).toEqual([
      { at: 0, moves: still(1) },
      { at: 0.5, moves: still(0.5) },
    ]);
    expect(withLoop(line([0, 0.5]), true).keys).toHaveLength(2);
    expect(withLoop(four, false)).toEqual({ ...four, loop: false });
    expect(withLoop(four, true)).toBe(four);
  });
});

it("tells rest from what is bent, and a box from another", () => {
  expect(isAtRest(AT_REST)).toBe(true);
  expect(isAtRest({ keys: [...AT_REST.keys, { at: 0.5, moves: [0, 1e-9] }] })).toBe(false);
  expect(sameBox([0, 0, 1, 1], [0, 1e-5, 1, 1])).toBe(true);
  expect(sameBox([0, 0, 1, 1], [0, 0.01, 1, 1])).toBe(false);
});
