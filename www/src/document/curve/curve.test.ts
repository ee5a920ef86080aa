import { expect, it, vi } from "vitest";
import type { Curve, CurveShape } from "#wasm/api";

const square: Curve = {
  knots: [
    [10, 10],
    [14, 10],
    [14, 14],
    [10, 14],
  ],
  edges: [null, null, null, null],
};
const { splineCurve, notify } = vi.hoisted(() => ({ splineCurve: vi.fn(), notify: vi.fn() }));
vi.mock("#wasm/curve", async () => ({
  curvesReady: (await import("@preact/signals")).signal(true),
  loadCurves: () => Promise.resolve(),
  rough: { splineCurve, quantised: (curve: Curve) => curve, CurveMorph: class {} },
}));
vi.mock("../notice", () => ({ notify, wordsOf: (problem: Error) => problem.message }));
const { scene, edit } = await import("../scene");
const { curves, knotted } = await import("./curve");
const { drawn, drawnEnds } = await import("./drawn");

const bare: CurveShape = { name: "Leaf", curve: { knots: [], edges: [] }, spline: "AbC" };

it("shapes of a link that hold a word are drawn as they were taken, and two of one word are one curve", () => {
  splineCurve.mockReturnValue(square);
  edit((before) => ({ ...before, curves: { a: bare, b: { ...bare, name: "Other" } } }));
  // Before there is what draws them.
  expect(curves.value?.a).toBe(bare);
  knotted.value = drawnEnds;
  const now = curves.value;
  // About the origin, its longer side 2.
  expect(now?.a.curve.knots[2]).toEqual([1, 1]);
  expect(now?.b.name).toBe("Other");
  expect(now?.b.curve).toBe(now?.a.curve);
  // What the document has stays what the link says.
  expect(scene.peek().curves?.a).toBe(bare);
});

it("what has its knots is drawn by them", () => {
  for (const shape of [
    { ...bare, curve: square },
    { name: "Oak", curve: square },
  ])
    expect(drawn(shape)).toBe(shape);
});

it("a word that is no curve is told", async () => {
  splineCurve.mockImplementation(() => {
    throw new Error("These bytes are no curve.");
  });
  const both = { a: bare, b: bare };
  expect(drawnEnds(both)).toBe(both);
  await Promise.resolve();
  expect(notify).toHaveBeenCalledWith({ kind: "error", text: "These bytes are no curve." });
});
