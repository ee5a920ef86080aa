/** Curves of the plane in Fit: what hands make of them, by the module that draws them. */
import { readFile } from "node:fs/promises";
import { beforeAll, beforeEach, describe, expect, it } from "vitest";
import * as frond from "../../www/pkg/frond-curve.js";
import { decodeScene, encodeScene, default as initFirst } from "../../www/pkg/frond-first.js";
import { changeFit } from "../../www/src/document/fit";
import { scene, start, undo } from "../../www/src/document/scene";
import { tool } from "../../www/src/document/tool";
import { asPlaneCurve, take } from "../../www/src/tools/fit/graph/model/document";
import {
  alongSide,
  type PlaneCurve,
  plainMaps,
  request,
  withPiece,
  withPlace,
  withPointIn,
} from "../../www/src/tools/fit/plane/model/curve";
import {
  change,
  curve,
  damage,
  maps,
  problem,
  refused,
  setFactor,
} from "../../www/src/tools/fit/plane/model/document";
import { EXAMPLES } from "../../www/src/tools/fit/plane/model/examples";
import { outlineOf, systemOf, takeOutline, takeSystem } from "../../www/src/tools/fit/plane/use";
import { rough } from "../../www/src/wasm/curve";

const blank = { ...scene.peek() };
const module = (name: string) => readFile(new URL(`../../www/pkg/${name}_bg.wasm`, import.meta.url));

beforeAll(async () => {
  await frond.default({ module_or_path: await module("frond-curve") });
  await initFirst({ module_or_path: await module("frond-first") });
  Object.assign(rough, frond);
});
beforeEach(() => start({ ...blank }));

const example = (id: string): PlaneCurve => EXAMPLES.find((one) => one.id === id)?.make() as PlaneCurve;
const mapsOf = (of: PlaneCurve) => {
  const { points, options } = request(of);
  return frond.interpolationCurve(points, options);
};

describe("examples", () => {
  it("are curves through their points", () => {
    for (const { id, make } of EXAMPLES) {
      const { points } = make();
      const line = frond.sampleInterpolationCurve(mapsOf(make()), { tolerance: 0.004 });
      for (const [, x, y] of points) {
        let nearest = Number.POSITIVE_INFINITY;
        for (let i = 0; i < line.length; i += 3) {
          nearest = Math.min(nearest, Math.hypot((line[i + 1] ?? 0) - x, (line[i + 2] ?? 0) - y));
        }
        expect(nearest, id).toBeLessThan(1e-6);
      }
    }
  });

  it("are attractors of maps of the plane where all copies lie along their sides", () => {
    const count = (id: string) => plainMaps(mapsOf(example(id)))?.length ?? null;
    expect([count("koch"), count("dragon"), count("arrowhead"), count("apart"), count("leaning")]).toEqual([
      4,
      2,
      3,
      null,
      null,
    ]);
    // A copy of a part is no copy of all.
    const part = withPiece(example("koch"), 1, { span: [0, 3] });
    const factor = alongSide(part, 1, false);
    if (factor) expect(plainMaps(mapsOf(withPiece(part, 1, { factor })))).toBeNull();
  });
});

it("a factor that lengthens is refused with its direction, and the last curve stays", () => {
  change(() => example("leaning"));
  expect(setFactor(1, [0.7, 0.7, 0.7, 0.7], "drag")).toBe(false);
  expect(problem.value).toMatch(/piece 2 makes the direction \(0.71, 0.71\) 1.400 times/);
  expect(refused.value).toEqual({ piece: 1, factor: [0.7, 0.7, 0.7, 0.7] });
  expect(curve.value).toEqual(example("leaning"));
  // A copy along its side that has become longer than what it copies.
  change(() => example("koch"));
  expect([problem.value, refused.value]).toEqual([null, null]);
  expect(change((now) => withPlace(now, 1, [5, 5]))).toBe(false);
  expect(problem.value).toMatch(/times as long/);
  // What copies a part that is no longer than itself says so.
  expect(change((now) => withPiece(now, 0, { span: [0, 1] }))).toBe(false);
  expect(problem.value).toMatch(/longer part/);
  expect(refused.value).toBeNull();
});

it("a curve is part of the document, its undo and its link", () => {
  change(() => example("apart"));
  change((now) => withPlace(now, 2, [-0.5, 0.25]));
  const link = encodeScene(scene.value);
  expect(link).toMatch(/fit=plane:/);
  const opened = decodeScene(link);
  expect(opened.problem ?? null).toBeNull();
  const made = curve.value;
  undo();
  expect(curve.value).toEqual(example("apart"));
  start(opened.scene);
  expect(curve.value).toEqual(made);
  expect(maps.value).toEqual(mapsOf(made));
  expect(damage.value).toBeNull();
});

it("a damaged curve is told, and something is drawn or nothing", () => {
  changeFit((fit) => ({ ...fit, mode: "plane", plane: "0,0,0;1,1" }));
  expect(damage.value).toMatch(/damaged/);
  expect(maps.value?.pieces.length).toBe(4);
  changeFit((fit) => ({ ...fit, plane: "0,0,0;1,1,0;2,0,1:0,0,0,0,0,2;0.8,0.8,0.8,0.8,0,2" }));
  expect(damage.value).toMatch(/direction/);
  expect(maps.value).toBeNull();
  expect([systemOf(), outlineOf()]).toEqual([null, null]);
});

it("goes into the morph as maps where it is their attractor, else as an outline", () => {
  change(() => example("koch"));
  const system = systemOf();
  expect(system?.maps.length).toBe(4);
  if (system) takeSystem(system, "b");
  expect([scene.value.b.name, scene.value.curves, scene.value.t]).toEqual([
    "Curve of the plane",
    undefined,
    1,
  ]);
  expect(tool.value).toBe("morph");
  change((now) => withPointIn(now, 1, [0.4, 0.5]));
  change(() => example("leaning"));
  expect(systemOf()).toBeNull();
  const outline = outlineOf();
  expect(outline?.curve.knots.length).toBeGreaterThan(300);
  expect(outline?.curve.knots.length).toBeLessThanOrEqual(1024);
  if (outline) takeOutline(outline, "bent");
  expect([scene.value.curves?.a.name, tool.value]).toEqual(["Curve of the plane", "deform"]);
  expect(encodeScene(scene.value).length).toBeLessThan(8000);
});

it("a graph becomes the same curve, point for point, cut where parts end between points", () => {
  const graph = frond.interpolation(
    [
      [0, 0],
      [1, 2],
      [2, 1],
      [4, 0],
    ],
    {
      c: [0.5, 0.4, -0.3],
      reflected: [false, true, false],
      spans: [
        [1, 3],
        [0, 2],
        [0, 3],
      ],
    },
  );
  for (const kind of ["rfif", "pfif"] as const) {
    take({ ...graph, kind });
    asPlaneCurve();
    const line = frond.sampleInterpolationCurve(mapsOf(curve.value), { tolerance: 0.01 });
    expect(line.length).toBeGreaterThan(300);
    for (let i = 0; i < line.length; i += 30) {
      const [t, x, y] = [line[i] ?? 0, line[i + 1] ?? 0, line[i + 2] ?? 0];
      expect(x).toBeCloseTo(t, 7);
      expect(y).toBeCloseTo(frond.graphAt(graph, t), 5);
    }
    expect(scene.value.fit?.mode).toBe("plane");
  }
});

it("in a window only what is there is followed, and the rest is NaN", () => {
  const of = mapsOf(example("koch"));
  const line = frond.sampleInterpolationCurve(of, { tolerance: 1e-5, window: [0.3, 0.1, 0.31, 0.11] });
  expect(line.some(Number.isNaN)).toBe(true);
  expect(line.length / 3).toBeLessThan(20_000);
  expect(() => frond.sampleInterpolationCurve(of, { window: [1, 0, 0, 1] })).toThrow(/window/);
});
