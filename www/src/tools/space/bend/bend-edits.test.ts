import { expect, test } from "vitest";
import type { Point3, Space, SpaceBend } from "#wasm/api";
import {
  asExample,
  atRest,
  EXAMPLES,
  foldedOf,
  isAtRest,
  linesOf,
  movedAt,
  placeOf,
  withBend,
  withDetail,
  withLocality,
  withMoved,
  withSizes,
} from "./bend-edits";

const rest = atRest([3, 3, 3], 3);

test("a control point goes as far as any, and nowhere by what is no number", () => {
  const moved = withMoved(rest, 26, [0.25, -99, 0]);
  expect(moved.moves[26]).toEqual([0.25, -10, 0]);
  expect(isAtRest(moved)).toBe(false);
  expect(isAtRest(withMoved(moved, 26, [-0.25, 10, 0]))).toBe(true);
  expect(withMoved(rest, 27, [1, 1, 1])).toBe(rest);
  expect(withMoved(rest, 0, [Number.NaN, 0, 0])).toBe(rest);
});

test("the locality is never above the detail", () => {
  expect(withLocality(rest, 9).kb).toBe(3);
  expect(withDetail(withLocality(rest, 3), 1)).toMatchObject({ ke: 1, kb: 1 });
});

test("corners of a finer lattice stay, and so does a linear displacement", () => {
  const linear = ([x, y, z]: Point3): Point3 => [x - y, 0.5 * z, x + y + z];
  const bend: SpaceBend = { ...rest, moves: rest.moves.map((_, i) => linear(placeOf(rest.sizes, i))) };
  const finer = withSizes(bend, [4, 2, 6]);
  expect(finer.moves).toHaveLength(48);
  for (const [i, by] of finer.moves.entries()) {
    const wanted = linear(placeOf(finer.sizes, i));
    for (const axis of [0, 1, 2] as const) expect(by[axis]).toBeCloseTo(wanted[axis], 12);
  }
  expect(movedAt(withMoved(rest, 26, [1, 2, 3]), [1, 1, 1])).toEqual([1, 2, 3]);
});

test("each pair of neighbours is a line once", () => {
  expect(linesOf([2, 2, 2])).toHaveLength(12);
  expect(linesOf([3, 3, 3])).toHaveLength(54);
  expect(linesOf([3, 2, 4])).toContainEqual([0, 6]);
});

test("only the object that is meant is bent, and straight again", () => {
  const object = { name: "Cube", maps: [] };
  const space = { objects: [object, object], light: {} } as unknown as Space;
  const bent = withBend(space, 1, rest);
  expect(bent.objects[0]).toEqual(object);
  expect(bent.objects[1]?.bend).toEqual(rest);
  expect(withBend(bent, 1, null)).toEqual(space);
});

test("every example moves something, and inside out turns the box over", () => {
  for (const example of EXAMPLES)
    expect(isAtRest(asExample(rest, example, [1, 1, 1])), example.id).toBe(false);
  const over = EXAMPLES.find(({ id }) => id === "inside-out");
  const turned = over && asExample(rest, over, [1, 0.5, 0.25]);
  expect(turned?.moves[0]).toEqual([1, 0.5, 0.25]);
  expect(turned?.moves[26]).toEqual([-1, -0.5, -0.25]);
  expect(turned && foldedOf(turned, [1, 0.5, 0.25])).toBe(1);
  expect(foldedOf(rest, [1, 0.5, 0.25])).toBe(0);
});
