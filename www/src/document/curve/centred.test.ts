import { expect, test } from "vitest";
import { centred } from "./centred";

test("a curve comes to lie about the origin, its longer side 2, and keeps its edges", () => {
  const edges = [null, { from: 0, span: 2, reversed: true, c: 0.3 }, null];
  const { knots, edges: after } = centred({
    knots: [
      [100, 100],
      [500, 100],
      [300, 200],
    ],
    edges,
  });
  expect(knots).toEqual([
    [-1, -0.25],
    [1, -0.25],
    [0, 0.25],
  ]);
  expect(after).toBe(edges);
});
