import { expect, it, vi } from "vitest";
import type { Curve, CurveShape } from "#wasm/api";
import { drawable, polygonOf } from "./polygon";

const square: Curve = {
  knots: [
    [10, 10],
    [14, 10],
    [14, 14],
    [10, 14],
  ],
  edges: [null, null, null, null],
};
const splineCurve = vi.hoisted(() => vi.fn());
vi.mock("#wasm/curve", () => ({ rough: { splineCurve, quantised: (curve: Curve) => curve } }));

const bare: CurveShape = { name: "Leaf", curve: { knots: [], edges: [] }, spline: "AbC" };

it("a shape of a link that holds a word is drawn as it was taken: about the origin, its longer side 2", () => {
  splineCurve.mockReturnValue(square);
  const drawn = drawable(bare);
  expect(drawn).toMatchObject({ name: "Leaf", spline: "AbC" });
  expect(drawn.curve.knots).toEqual([
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ]);
  // Two of one word are one curve, and it is made once.
  expect(drawable({ ...bare, name: "Other" }).curve).toBe(drawn.curve);
  expect(polygonOf("AbC")).toBe(square);
  expect(splineCurve).toHaveBeenCalledTimes(1);
});

it("what has its knots is drawn by them", () => {
  const [taken, plain] = [
    { ...bare, curve: square },
    { name: "Oak", curve: square },
  ];
  expect([drawable(taken), drawable(plain)]).toEqual([taken, plain]);
  expect(drawable(taken)).toBe(taken);
});
