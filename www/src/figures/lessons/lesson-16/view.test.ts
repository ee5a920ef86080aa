import { expect, it } from "vitest";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { pieceOf } from "./address";
import { between, partAt, triangleOf, trianglesIn, viewOf, WHOLE } from "./view";

it("sees the pieces where their maps take them", () => {
  for (const letters of [[], [2], [0, 2], [2, 1, 0, 1]]) {
    const [side, , , , x, y] = pieceOf(gasket(0.5), { first: letters, again: [] });
    const triangle = triangleOf(letters);
    for (const [key, value] of Object.entries({ x, y, side }))
      expect(triangle[key as keyof typeof triangle]).toBeCloseTo(value, 12);
  }
});

it("knows which part of a piece was pressed", () => {
  for (const letter of [0, 1, 2]) {
    const { x, y, side } = triangleOf([2, letter]);
    expect(partAt([2], [x + side / 2, y + side / 4])).toBe(letter);
  }
  expect(partAt([], [0.5, HEIGHT / 4])).toBeNull();
  expect(partAt([2], [0.1, 0.1])).toBeNull();
});

it("draws what is seen, as fine as is asked, and no more", () => {
  const whole = trianglesIn(viewOf(WHOLE), 1 / 8, 2);
  expect(whole).toHaveLength(27);
  expect(new Set(whole.map(({ letters }) => letters.join(""))).size).toBe(9);
  // However deep, there is no more to draw than on the whole and what stands beside it.
  const deep = trianglesIn(viewOf(triangleOf(Array.from({ length: 12 }, () => 1))), 2 ** -18, 13);
  expect(deep.length).toBeGreaterThan(3 ** 6);
  expect(deep.length).toBeLessThan(3 * 3 ** 6);
});

it("flies from view to view by equal factors", () => {
  const [from, to] = [viewOf(WHOLE), viewOf(triangleOf([2, 1]))];
  expect(between(from, to, 0)).toEqual(from);
  expect(between(from, to, 1)).toEqual(to);
  expect(between(from, to, 0.5).width).toBeCloseTo(from.width / 2, 12);
});
