import { describe, expect, it } from "vitest";
import type { MapRow3, Shape3, Space, SpaceLight } from "#wasm/api";
import {
  exchanged,
  flatPairs,
  inOrder,
  leadingTo,
  MOST_POINTS,
  optionsOf,
  orderNow,
  startingWith,
  swapped,
  withMode,
  withOrder,
  withPath,
} from "./morph-edits";

const light: SpaceLight = { paint: "map", side: 0, front: 0.5, ambient: 0.3, hollows: 0.5, fog: 0 };
const half = (x: number): MapRow3 => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, x, 0, 0];
const A: Shape3 = { preset: "a", name: "A", maps: [half(0), half(1), half(2)] };
const B: Shape3 = { name: "B", maps: [half(3), half(4), half(5)] };
const plain: Space = { objects: [A, { name: "other", maps: [half(9)] }], light };
const morphing = leadingTo(plain, B, [1, 2, 0]);

describe("leading the first object to a shape", () => {
  it("asks for a path and remembers which map becomes which", () => {
    expect(morphing.morph).toEqual({
      to: B,
      path: { kind: "auto", points: [] },
      t: 0,
      correspondence: [1, 2, 0],
    });
    expect(morphing.objects).toBe(plain.objects);
  });

  it("says nothing of an order that goes without saying", () => {
    expect(leadingTo(plain, B, [0, 1, 2]).morph).not.toHaveProperty("correspondence");
  });

  it("keeps how far it was and how it goes", () => {
    const before = withMode({ ...morphing, morph: { ...morphing.morph, t: 0.3 } as never }, "linear");
    expect(leadingTo(before, A, [0, 1, 2]).morph).toMatchObject({ t: 0.3, mode: "linear" });
  });

  it("takes what keys said of its maps, and of no others", () => {
    const timeline = {
      seconds: 4,
      loop: "round" as const,
      course: "smooth" as const,
      keys: [
        { at: 0, ease: "even" as const, maps: [A.maps, null] },
        { at: 1, ease: "even" as const, maps: [A.maps, [half(1)]] },
      ],
    };
    const keys = leadingTo({ ...plain, timeline }, B, [0, 1, 2]).timeline?.keys;
    expect(keys).toEqual([{ at: 1, ease: "even", maps: [null, [half(1)]] }]);
  });

  it("can begin with two shapes alone", () => {
    const timeline = { seconds: 4, loop: "round" as const, course: "smooth" as const, keys: [] };
    const after = startingWith({ ...plain, timeline }, B, A, [0, 1, 2]);
    expect(after.objects).toEqual([B]);
    expect(after).not.toHaveProperty("timeline");
  });
});

describe("the other way round", () => {
  const drawn = withPath(morphing, {
    kind: "drawn",
    points: [
      [0.2, 0.1],
      [0.9, 0.4],
    ],
  });
  const placed: Space = {
    ...drawn,
    objects: drawn.objects.map((o, i) => (i === 0 ? { ...o, tint: "#123456" } : o)),
    morph: { ...drawn.morph, t: 0.25, turns: [1, 0, -2] } as never,
  };

  it("is the same morph", () => {
    const { objects, morph } = swapped(placed);
    expect(objects[0]).toEqual({ ...B, tint: "#123456" });
    expect(morph).toEqual({
      to: A,
      path: {
        kind: "drawn",
        points: [
          [0.1, 0.6],
          [0.8, 0.9],
        ],
      },
      t: 0.75,
      correspondence: [2, 0, 1],
      turns: [2, -1, 0],
    });
  });

  it("makes up no digits", () => {
    const { morph } = swapped(withPath(morphing, { kind: "drawn", points: [[1.001, 0.3]] }));
    expect(morph?.path.points).toEqual([[-0.001, 0.7]]);
  });

  it("comes back to where it was", () => {
    const twice = swapped(swapped(placed));
    expect(twice.objects).toEqual(placed.objects);
    expect(twice.morph?.correspondence).toEqual(placed.morph?.correspondence);
    expect(twice.morph?.turns).toEqual(placed.morph?.turns);
  });

  it("turns what keys say of it, too", () => {
    const timeline = {
      seconds: 4,
      loop: "round" as const,
      course: "smooth" as const,
      keys: [{ at: 0, ease: "even" as const, t: 0.1 }],
    };
    expect(swapped({ ...placed, timeline }).timeline?.keys[0]?.t).toBeCloseTo(0.9);
  });

  it("is nothing where there is no morph", () => {
    expect(swapped(plain)).toBe(plain);
  });
});

describe("which map becomes which", () => {
  it("is one to one, whatever is exchanged", () => {
    expect(exchanged([0, 1, 2], 0, 2)).toEqual([2, 1, 0]);
    expect(exchanged([1, 2, 0], 1, 2)).toEqual([1, 2, 0]);
  });

  it("is in order where the list does not fit", () => {
    expect(orderNow({ correspondence: [1, 0] }, 3)).toEqual([0, 1, 2]);
    expect(inOrder(orderNow({}, 3))).toBe(true);
    expect(optionsOf({ correspondence: [1, 0], turns: [] }, 3)).toEqual({ mode: "polar" });
  });

  it("asks for another path, but leaves one that was drawn", () => {
    const found = withPath(morphing, { kind: "auto", points: [[0.1, 0.9]] });
    expect(withOrder(found, [0, 1, 2]).morph?.path.points).toEqual([]);
    const drawn = withPath(morphing, { kind: "drawn", points: [[0.1, 0.9]] });
    expect(withMode(drawn, "linear").morph?.path.points).toEqual([[0.1, 0.9]]);
  });

  it("tells which maps must become flat", () => {
    const mirrored: MapRow3 = [-0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, 0, 0, 0];
    expect(flatPairs(A.maps, [mirrored, half(1), half(2)], [1, 0, 2])).toEqual([2]);
  });
});

it("keeps a path to what a link holds", () => {
  const points = Array.from({ length: 70 }, (): [number, number] => [0.5, 0.5]);
  expect(withPath(morphing, { kind: "drawn", points }).morph?.path.points).toHaveLength(MOST_POINTS);
});
