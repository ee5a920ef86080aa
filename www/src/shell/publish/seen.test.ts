import { expect, it } from "vitest";
import type { CurveShape, Fit, Scene } from "#wasm/api";
import { seenOf } from "./seen";

const shape = (name: string) => ({ name, maps: [[0.5, 0, 0, 0.5, 0, 0]] }) as Scene["a"];
const plain: Scene = {
  a: shape("plain"),
  b: shape("other"),
  mode: "polar",
  path: { kind: "auto", points: [] },
  t: 0,
  correspondence: [],
  turns: [],
  colouring: "map",
  compare: false,
};
const curve = (name: string, preset?: string): CurveShape => ({
  name,
  ...(preset ? { preset } : {}),
  curve: {
    knots: [
      [0, 0],
      [1, 0],
      [0, 1],
    ],
    edges: [null, null, null],
  },
});
const fit: Fit = { mode: "outline", model: "closed", numbers: 260, smoothing: 0 };
const mine = { ...plain, a: shape("my fern"), turns: [1], mode: "linear" as const, fit };

it("keeps the systems where they are seen, and the fit in Fit", () => {
  expect(seenOf(mine, plain)).toEqual({ ...plain, a: shape("my fern"), turns: [1], mode: "linear" });
  expect(seenOf({ ...mine, tool: "fit" }, plain).fit).toBe(fit);
});

it("keeps how shapes of several states are mixed", () => {
  const directed = {
    a: { name: "two", states: [] },
    b: { name: "more", states: [] },
  } as unknown as Scene["directed"];
  const seen = seenOf({ ...mine, ...(directed ? { directed } : {}) }, plain);
  expect(seen).toEqual({ ...plain, mode: "linear", directed });
});

it("leaves out what closed curves hide", () => {
  const curves = { a: curve("leaf"), b: curve("other leaf") };
  expect(seenOf({ ...mine, curves }, plain)).toEqual({ ...plain, curves });
});

it("bends one end and leaves the other out, unless the gallery has it", () => {
  const leaf = curve("leaf");
  const bent = (t: number, curves: NonNullable<Scene["curves"]>) =>
    seenOf({ ...mine, curves, t, tool: "deform" }, plain).curves;
  expect(bent(0, { a: leaf, b: curve("old") })).toEqual({ a: leaf, b: leaf });
  expect(bent(1, { a: curve("old"), b: leaf })).toEqual({ a: leaf, b: leaf });
  const oak = curve("Oak leaf", "white-oak");
  expect(bent(0, { a: leaf, b: oak })).toEqual({ a: leaf, b: oak });
  // In the midst both are seen.
  const both = { a: leaf, b: curve("old") };
  expect(bent(0.5, both)).toEqual(both);
});
