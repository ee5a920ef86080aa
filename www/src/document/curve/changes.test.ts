import { describe, expect, it } from "vitest";
import type { CurveShape, Scene } from "#wasm/api";
import { scene as present } from "../scene";
import { curveAtBoth, sameCurves, swapCurves, withCurve, withoutCurves } from "./changes";

const SYSTEMS = present.peek();
const shape = (name: string, x = 0): CurveShape => ({
  name,
  curve: {
    knots: [
      [x, 0],
      [x + 1, 0],
      [x, 1],
    ],
    edges: [null, null, null],
  },
});
const [maple, oak, isle] = [shape("Maple"), shape("Oak", 1), shape("Isle", 2)];
const AROUND = () => [0, 0, 2, 2] as [number, number, number, number];

const bent = (scene: Scene, subject: "shape" | "picture"): Scene => ({
  ...scene,
  deform: {
    on: true,
    subject,
    parts: 2,
    columns: 2,
    rows: 2,
    box: [0, 0, 1, 1],
    keys: [{ at: 0, moves: [0.1, 0, 0, 0, 0, 0, 0, 0.2] }],
    phase: 0,
    seconds: 4,
    loop: true,
    kb: 0,
    ke: 9,
    delta: 0.5,
    spin: "none",
    continuity: "auto",
    superposed: true,
  },
});

describe("curves in a document", () => {
  it("come in pairs: the first one brings a partner, the next one leaves the other where it is", () => {
    const first = withCurve({ ...SYSTEMS, view: { x: 0, y: 0, zoom: 9 } }, "b", oak, maple);
    expect(first.curves).toEqual({ a: maple, b: oak });
    expect(first.view).toBeUndefined();
    expect(first.a).toBe(SYSTEMS.a);
    const zoomed = { ...first, view: { x: 0, y: 0, zoom: 9 } };
    const second = withCurve(zoomed, "a", isle, maple);
    expect(second.curves).toEqual({ a: isle, b: oak });
    expect(second.view).toEqual(zoomed.view);
  });

  it("give way to the systems, which were there all the time", () => {
    const there = withCurve(SYSTEMS, "a", maple, oak);
    expect(withoutCurves(there)).toEqual(SYSTEMS);
    expect(withoutCurves(SYSTEMS)).toBe(SYSTEMS);
  });

  it("take a mesh along with its bend, but not that of a picture", () => {
    const there = withCurve(bent(SYSTEMS, "shape"), "a", maple, oak, AROUND);
    expect(there.deform?.box).toEqual([0, 0, 2, 2]);
    expect(there.deform?.keys[0]?.moves).toEqual([0.2, 0, 0, 0, 0, 0, 0, 0.4]);
    const picture = bent(SYSTEMS, "picture");
    expect(withCurve(picture, "a", maple, oak, AROUND).deform).toBe(picture.deform);
    expect(withCurve(bent(SYSTEMS, "shape"), "a", maple, oak).deform?.box).toEqual([0, 0, 1, 1]);
    expect(withoutCurves(there, () => [0, 0, 1, 1]).deform?.keys[0]?.moves[0]).toBeCloseTo(0.1, 12);
  });

  it("are swapped with the moment, and doubled", () => {
    const there = { ...withCurve(SYSTEMS, "a", maple, oak), t: 0.25 };
    const swapped = swapCurves(there);
    expect([swapped.curves?.a, swapped.curves?.b, swapped.t]).toEqual([oak, maple, 0.75]);
    expect(swapCurves(swapped)).toEqual(there);
    expect(curveAtBoth(there, "b").curves).toEqual({ a: oak, b: oak });
    expect(swapCurves(SYSTEMS)).toBe(SYSTEMS);
    expect(curveAtBoth(SYSTEMS, "a")).toBe(SYSTEMS);
  });

  it("are the same where their knots and copies are, whatever they are called", () => {
    expect(sameCurves({ a: maple, b: { ...shape("Other"), preset: "x" } })).toBe(true);
    expect(sameCurves({ a: maple, b: oak })).toBe(false);
  });
});
