import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as frond from "../../www/pkg/index.js";
import { heightsAlong, TOP } from "../../www/src/figures/cochran/graphs/arrowhead";
import { TABLE_3 } from "../../www/src/figures/cochran/graphs/printed-tables";

type Graph = ReturnType<typeof frond.interpolation>;
type Row = [number, number, number, number, number];

interface Known {
  points?: [number, number][];
  t_knots?: number[];
  x_knots?: number[];
  c: number[];
  reflect?: number[];
  jk?: [number, number][];
  maps_abcde: Row[];
  t: number[];
  F: number[];
  integral?: number;
  box_dim_formula?: number;
}

interface KnownTable {
  maps_abcde: Row[];
  domain: [number, number];
  F_left: number;
  F_right: number;
  join_left_limit: number;
  join_right_limit: number;
  box_dim_formula: number;
}

/** The project's own copy, or the directory that FROND_KNOWN names. */
const folder = process.env["FROND_KNOWN"] ?? "tests/known";
const known: Record<string, Known | KnownTable> = JSON.parse(readFileSync(`${folder}/fit/fif.json`, "utf8"));
/** Cases are told by what is in them, and not by their names. */
const functions = Object.entries(known).filter((entry): entry is [string, Known] => "c" in entry[1]);
const tables = Object.entries(known).filter((entry): entry is [string, KnownTable] => "domain" in entry[1]);

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

function points(one: Known): [number, number][] {
  return one.points ?? (one.t_knots ?? []).map((t, i) => [t, one.x_knots?.[i] ?? Number.NaN]);
}

function make(one: Known): Graph {
  const { c, reflect, jk } = one;
  return frond.interpolation(points(one), {
    c,
    ...(reflect && { reflected: reflect.map((flag) => flag === 1) }),
    ...(jk && { spans: jk }),
  });
}

/** t and F(t) of a rough function, by exact fractions of the numbers of its maps. */
const ROUGH = [
  [0.0123, 0.16238540663349613],
  [0.05, -0.044157815867358334],
  [0.0777, 0.177959555765068],
  [0.11, 0.08268693265428728],
  [0.031, -0.13187548300409435],
] as const;

function expectCode(work: () => unknown, code: string): void {
  expect(work).toThrowError(expect.objectContaining({ code }));
}

describe("fractal functions", () => {
  beforeAll(() =>
    init({
      frond: read("frond_bg.wasm"),
      curve: read("frond-curve_bg.wasm"),
      proof: read("frond-proof_bg.wasm"),
    }),
  );

  it("have cases of each kind to agree with", () => {
    expect(functions.filter(([, one]) => one.jk)).not.toEqual([]);
    expect(functions.filter(([, one]) => !one.jk)).not.toEqual([]);
    expect(tables).not.toEqual([]);
  });

  it.each(functions)("agree with the known %s", (_, one) => {
    const graph = make(one);
    expect(graph.kind).toBe(one.jk ? "rfif" : "fif");
    for (const [i, piece] of graph.pieces.entries()) {
      for (const [k, number] of piece.map.entries()) {
        expect(number).toBeCloseTo(one.maps_abcde[i]?.[k] ?? Number.NaN, 12);
      }
    }
    for (const [i, t] of one.t.entries()) {
      expect(frond.graphAt(graph, t)).toBeCloseTo(one.F[i] ?? Number.NaN, 9);
    }
    const facts = frond.graphFacts(graph);
    expect(facts.continuous).toBe(true);
    expect(facts.contractivity).toBeLessThan(1);
    if (one.integral !== undefined) expect(facts.integral).toBeCloseTo(one.integral, 12);
    if (one.box_dim_formula !== undefined) {
      expect(facts.dimension).toBeCloseTo(one.box_dim_formula, 12);
      expect(facts.counted).toBe(false);
    }
  });

  it("are sampled within a tolerance, and finer in a window", () => {
    const graph = frond.interpolation(
      [
        [0, 0.5],
        [0.2, 1],
        [0.7, -0.5],
        [1, 0.25],
      ],
      { c: [1 / 3, -0.4, 0.5] },
    );
    const all = frond.sampleGraph(graph, { tolerance: 1e-2 });
    const part = frond.sampleGraph(graph, { tolerance: 1e-4, window: [0.3, 0.302] });
    expect([all.at(0), all.at(-2), part.at(0), part.at(-2)]).toEqual([0, 1, 0.3, 0.302]);
    const times = part.filter((_, i) => i % 2 === 0);
    expect(times.every((t, i) => i === 0 || t > (times[i - 1] ?? NaN))).toBe(true);
    // A few of the many.
    let worst = 0;
    for (let i = 2; i < part.length; i += 2 * Math.ceil(part.length / 400)) {
      const [t0 = NaN, x0 = NaN, t1 = NaN, x1 = NaN] = part.slice(i - 2, i + 2);
      const between = frond.graphAt(graph, t0 + 0.618 * (t1 - t0));
      worst = Math.max(worst, Math.abs(between - x0), Math.abs(between - x1));
    }
    expect(worst).toBeGreaterThan(1e-6);
    expect(worst).toBeLessThanOrEqual(1.0001e-4);
    expect(frond.sampleGraph(graph, { tolerance: 0, most: 500 }).length).toBeLessThanOrEqual(1000);
  });

  it("that copy any part go through their points, and become recurrent where they can", () => {
    const knots: [number, number][] = [
      [0, 0],
      [0.3, 1],
      [0.55, -0.5],
      [1, 0.25],
    ];
    const free = frond.interpolation(knots, {
      c: [0.4, -0.3, 0.5],
      domains: [
        [0.1, 0.83],
        [0.27, 0.9],
        [0, 0.71],
      ],
    });
    expect(free.kind).toBe("pfif");
    for (const [t, x] of knots) expect(frond.graphAt(free, t)).toBeCloseTo(x, 9);
    expect(frond.graphFacts(free)).toMatchObject({ continuous: true, integral: null, counted: true });
    expect(frond.toRecurrent(free, 8)).toBeNull();
    const whole = frond.interpolation(
      [
        [0, 0],
        [0.5, 1],
        [1, 0],
      ],
      { c: [0.6, 0.4] },
    );
    const again = frond.toRecurrent({ ...whole, kind: "pfif" }, 64);
    expect(again?.kind).toBe("rfif");
    expect(again?.pieces.length).toBe(2);
  });

  it.each(tables)("need not meet: the known %s, whose maps meet only to rounding", (_, table) => {
    const { maps_abcde, domain, F_left, F_right, box_dim_formula } = table;
    const graph: Graph = { kind: "pfif", pieces: maps_abcde.map((map) => ({ map, domain })) };
    expect(frond.graphAt(graph, domain[0])).toBeCloseTo(F_left, 14);
    expect(frond.graphAt(graph, domain[1])).toBeCloseTo(F_right, 14);
    const facts = frond.graphFacts(graph);
    expect(facts.continuous).toBe(false);
    expect(facts.widestGap).toBeCloseTo(Math.abs(table.join_left_limit - table.join_right_limit), 9);
    expect(facts.dimension).toBeCloseTo(box_dim_formula, 9);
    expect(facts.interval).toEqual(domain);
  });

  it("take a table of three digits as it is printed, slits and all", () => {
    // How far Table 3 is from the curve of Figure 4: 0.0858 and 0.000180 in the paper, which does not say where.
    const graph: Graph = { kind: "pfif", pieces: [...TABLE_3] };
    const heights = heightsAlong(7, TOP);
    let [worst, squares] = [0, 0];
    for (let i = 0; i < heights.length; i += 2) {
      const miss = Math.abs(frond.graphAt(graph, heights[i] ?? 0) - (heights[i + 1] ?? 0));
      [worst, squares] = [Math.max(worst, miss), squares + (2 * miss * miss) / heights.length];
    }
    expect(worst).toBeCloseTo(0.08861, 4);
    expect(squares).toBeCloseTo(0.000183, 6);
    expect(frond.graphFacts(graph)).toMatchObject({ continuous: false });
    expect(frond.toRecurrent(graph, 100)).toBeNull();
    const wide = TABLE_3.map(({ map: [a, b, c, d, e], domain }, i) => ({
      map: [a, b, c, i === 3 ? d - 0.004 : d, e] as Row,
      domain,
    }));
    expectCode(() => frond.graphAt({ kind: "pfif", pieces: wide }, 0.5), "not-joined");
  });

  it("have values that do not lose their digits where roughness is high and a piece is short", () => {
    const rough = frond.interpolation(
      [
        [0, 0.3],
        [0.12, -0.4],
        [0.55, 0.9],
        [1, 0.1],
      ],
      { c: [0.87, -0.8, 0.6] },
    );
    for (const [t, x] of ROUGH) expect(frond.graphAt(rough, t)).toBeCloseTo(x, 13);
  });

  it("say what is wrong with them", () => {
    const line: [number, number][] = [
      [0, 0],
      [0.5, 1],
      [1, 0],
    ];
    const c = [0.1, 0.1];
    expectCode(() => frond.interpolation([], { c: [] }), "too-few-points");
    expectCode(() => frond.interpolation(line, { c: [0.1] }), "wrong-count");
    expectCode(() => frond.interpolation(line, { c: [1, 0.1] }), "not-contractive");
    expectCode(() => frond.interpolation(line, { c: [Number.NaN, 0.1] }), "not-finite");
    expectCode(() => frond.interpolation([...line].reverse(), { c }), "not-increasing");
    expectCode(
      () =>
        frond.interpolation(line, {
          c,
          spans: [
            [0, 1],
            [0, 2],
          ],
        }),
      "bad-domain",
    );
    expectCode(
      () =>
        frond.interpolation(line, {
          c,
          spans: [
            [0, 1e9],
            [0, 2],
          ],
        }),
      "bad-input",
    );
    expectCode(
      () =>
        frond.interpolation(line, {
          c,
          spans: [
            [0, 2],
            [0, 2],
          ],
          domains: [
            [0, 1],
            [0, 1],
          ],
        }),
      "bad-input",
    );
    expectCode(
      () =>
        frond.interpolation(line, {
          c,
          domains: [
            [0, 2],
            [0, 1],
          ],
        }),
      "bad-domain",
    );
    expectCode(() => frond.interpolation(new Array(1_000_000), { c }), "too-many-points");
    expectCode(() => frond.interpolation(line, { c: new Array(1_000_000) }), "too-many-points");
    expectCode(() => frond.interpolation(undefined as never, { c }), "bad-input");
    expectCode(() => frond.interpolation(line, undefined as never), "bad-input");
    const good = frond.interpolation(line, { c });
    const pieces = good.pieces;
    for (const bad of [
      undefined,
      {},
      { kind: "fif" },
      { kind: "x", pieces },
      { kind: "fif", pieces: [null] },
    ]) {
      expectCode(() => frond.graphAt(bad as never, 0), "bad-input");
    }
    expectCode(() => frond.graphFacts({ kind: "fif", pieces: [] }), "too-few-points");
    expectCode(() => frond.graphFacts({ kind: "fif", pieces: new Array(1_000_000) }), "too-many-points");
    expectCode(() => frond.graphFacts({ kind: "fif", pieces: [...pieces, ...pieces] }), "not-joined");
    for (const most of [Number.NaN, 1, -5, 1e12]) {
      expectCode(() => frond.sampleGraph(good, { most }), "bad-input");
    }
    for (const tolerance of [Number.NaN, -1, Number.POSITIVE_INFINITY]) {
      expectCode(() => frond.sampleGraph(good, { tolerance }), "bad-input");
    }
    expectCode(() => frond.sampleGraph(good, { window: [1, 0] }), "bad-input");
    expectCode(() => frond.sampleGraph(good, { window: [Number.NaN, 0] }), "bad-input");
    expectCode(() => frond.toRecurrent(good, Number.NaN), "bad-input");
    expect(frond.graphAt(good, Number.NaN)).toBe(0);
    expect(frond.sampleGraph(good, { window: [5, 6] })).toHaveLength(4);
  });
});

describe("fractal curves of the plane", () => {
  const knots: [t: number, x: number, y: number][] = [
    [0, 0, 0],
    [0.4, 0.5, 1],
    [1, 1, 0.25],
  ];
  const column = (flat: Float64Array, k: number) => [...flat.filter((_, i) => i % 3 === k)];

  it("are two functions of one t where they are separable (eq 8)", () => {
    const curve = frond.interpolationCurve(knots, {
      factors: [
        [0.5, 0, 0, -0.3],
        [0.2, 0, 0, 0.6],
      ],
      reflected: [false, true],
    });
    const graph = (k: 1 | 2, c: number[]) =>
      frond.interpolation(
        knots.map((knot): [number, number] => [knot[0], knot[k]]),
        { c, reflected: [false, true] },
      );
    const [x, y] = [graph(1, [0.5, 0.2]), graph(2, [-0.3, 0.6])];
    for (const [i, { map }] of curve.pieces.entries()) {
      const [a, bx, by, cx, cxy, cyx, cy, d, ex, ey] = map;
      expect([cxy, cyx]).toEqual([0, 0]);
      expect([a, bx, cx, d, ex]).toEqual(x.pieces[i]?.map);
      expect([a, by, cy, d, ey]).toEqual(y.pieces[i]?.map);
    }
    const flat = frond.sampleInterpolationCurve(curve, { tolerance: 0.01 });
    for (const [i, t] of column(flat, 0).entries()) {
      expect(flat[3 * i + 1]).toBeCloseTo(frond.graphAt(x, t), 6);
      expect(flat[3 * i + 2]).toBeCloseTo(frond.graphAt(y, t), 6);
    }
  });

  it("draw the gasket from three maps that mix x and y (eq 9)", () => {
    const s = Math.sqrt(3) / 4;
    const curve = frond.interpolationCurve(
      [
        [0, 0, 0],
        [1 / 3, 0.25, s],
        [2 / 3, 0.75, s],
        [1, 1, 0],
      ],
      {
        factors: [
          [0.25, s, s, -0.25],
          [0.5, 0, 0, 0.5],
          [0.25, -s, -s, -0.25],
        ],
      },
    );
    expect(curve.contractivity).toBeCloseTo(2 / 3, 12);
    for (const { map } of curve.pieces)
      expect(map.slice(1, 3)).toEqual([expect.closeTo(0), expect.closeTo(0)]);
    const flat = frond.sampleInterpolationCurve(curve, { tolerance: 0.004 });
    const [t, x, y] = [0, 1, 2].map((k) => column(flat, k)) as [number[], number[], number[]];
    expect(t.every((at, i) => i === 0 || at > (t[i - 1] ?? 0))).toBe(true);
    // No point lies in the middle hole, nor outside.
    for (const [i, across] of x.entries()) {
      const up = (y[i] ?? 0) / (2 * s);
      const weights = [1 - across - up / 2, across - up / 2, up];
      expect(Math.min(...weights)).toBeGreaterThan(-1e-9);
      expect(Math.max(...weights)).toBeGreaterThan(0.5 - 1e-9);
    }
    const few = frond.sampleInterpolationCurve(curve, { tolerance: 0, most: 100 });
    expect(few.length).toBeLessThanOrEqual(300);
    expect(few.length).toBeGreaterThan(30);
  });

  it("are refused, in words, where a factor does not shrink or lists do not fit", () => {
    const make = (factors: number[][]) => () =>
      frond.interpolationCurve(knots, { factors: factors as [number, number, number, number][] });
    // Each number is small, and yet a direction grows.
    expectCode(
      make([
        [0.7, 0.7, 0.7, 0.7],
        [0, 0, 0, 0],
      ]),
      "not-contractive",
    );
    expectCode(make([[0, 0, 0, 0]]), "wrong-count");
    expectCode(
      make([
        [Number.NaN, 0, 0, 0],
        [0, 0, 0, 0],
      ]),
      "not-finite",
    );
    expectCode(() => frond.interpolationCurve([[0, 0, 0]], { factors: [] }), "too-few-points");
    const whole = make([
      [0.1, 0, 0, 0.1],
      [0.1, 0, 0, 0.1],
    ])();
    expectCode(() => frond.sampleInterpolationCurve(whole, { most: 1 }), "bad-input");
    expectCode(() => frond.sampleInterpolationCurve({ pieces: [] }, {}), "too-few-points");
  });
});
