import { expect, test } from "vitest";
import { about3, apply3, scale3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3, Space } from "#wasm/api";
import { around, beside, withObject, withoutObject, withShape, withTint } from "./object-edits";

const half: MapRow3 = scale3([0.5, 0.5, 0.5]);
const third: MapRow3 = about3(half, [1, 0, 0]);
const light: Space["light"] = { paint: "map", side: 0, front: 0.5, ambient: 0.3, hollows: 0.5, fog: 0 };

const still: Space = {
  objects: [
    { name: "One", maps: [half, third] },
    { name: "Two", maps: [half], moved: third, tint: "#102030" },
  ],
  light,
};
const moving: Space = {
  ...still,
  morph: { to: { name: "Three", maps: [third, half] }, path: { kind: "straight", points: [] }, t: 0.5 },
  timeline: {
    seconds: 6,
    loop: "round",
    course: "smooth",
    keys: [
      { at: 0, ease: "inout", moved: [half, third], t: 0 },
      { at: 3, ease: "inout", maps: [null, [third]] },
      { at: 5, ease: "inout", moved: [null, half] },
    ],
  },
};

test("a shape with as many maps goes on to morph and to move", () => {
  const after = withShape(moving, 0, { name: "New", maps: [third, half], preset: "new" });
  expect(after.objects[0]).toEqual({ name: "New", maps: [third, half], preset: "new" });
  expect(after.morph).toEqual(moving.morph);
  expect(after.timeline).toEqual(moving.timeline);
});

test("one with another number of maps drops what was said of them", () => {
  const first = withShape(moving, 0, { name: "New", maps: [half] });
  expect(first.morph).toBeUndefined();
  expect(first.timeline?.keys.map((key) => key.t)).toEqual([undefined, undefined, undefined]);
  const second = withShape(moving, 1, { name: "New", maps: [half, third] });
  expect(second.morph).toEqual(moving.morph);
  // The key that said nothing else is gone.
  expect(second.timeline?.keys.map((key) => key.at)).toEqual([0, 5]);
  expect(second.objects[1]).toEqual({
    name: "New",
    maps: [half, third],
    moved: third,
    tint: "#102030",
  });
});

test("an object leaves with its part of every key", () => {
  const left = withoutObject(moving, 0);
  expect(left.objects.map(({ name }) => name)).toEqual(["Two"]);
  expect(left.morph).toBeUndefined();
  expect(left.timeline?.keys).toEqual([
    { at: 0, ease: "inout", moved: [third] },
    { at: 3, ease: "inout", maps: [[third]] },
    { at: 5, ease: "inout", moved: [half] },
  ]);
  expect(withoutObject(withoutObject(moving, 1), 0)).toEqual(withoutObject(moving, 1));
  expect(withoutObject(moving, 1).timeline?.keys.map((key) => key.at)).toEqual([0]);
});

test("objects are added up to the most there may be", () => {
  let space = still;
  for (let i = 0; i < 100; i++) space = withObject(space, { name: "More", maps: [half] });
  expect(space.objects).toHaveLength(60);
});

test("a colour for all of an object, and none", () => {
  expect(withTint(still, 0, "#ff0000").objects.map(({ tint }) => tint)).toEqual(["#ff0000", "#102030"]);
  expect("tint" in (withTint(still, 1, null).objects[1] ?? {})).toBe(false);
});

test("what is put beside touches nothing", () => {
  const balls = [
    { centre: [0, 0, 0] as Point3, radius: 1 },
    { centre: [4, 0, 2] as Point3, radius: 0.5 },
  ];
  const all = around(balls);
  for (const { centre, radius } of balls) {
    const reach = Math.hypot(...centre.map((x, k) => x - (all.centre[k] ?? 0))) + radius;
    expect(reach).toBeLessThanOrEqual(all.radius + 1e-12);
  }
  const shape = { centre: [15, 3, 0] as Point3, radius: 0.1 };
  const by = beside(shape, all, 2);
  const [x, y, z] = apply3(by, shape.centre);
  expect(x - 2).toBeGreaterThan(all.centre[0] + all.radius);
  expect([y, z]).toEqual([all.centre[1], all.centre[2]]);
  expect(apply3(by, [15.1, 3, 0])[0] - x).toBeCloseTo(2, 9);
});
