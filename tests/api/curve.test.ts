import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import type { Curve } from "../../crate/web/src/api";
import init, * as frond from "../../www/pkg/index.js";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** A hexagon, one of whose sides copies three others. */
function hexagon(c = -0.4): Curve {
  const knots = Array.from({ length: 6 }, (_, i): [number, number] => [
    Math.cos((i * Math.PI) / 3),
    Math.sin((i * Math.PI) / 3),
  ]);
  const copy = { from: 2, span: 3, reversed: true, c };
  return { knots, edges: [copy, null, null, null, null, null] };
}

function bend(moves: number[], more: object = {}) {
  return {
    columns: 2,
    rows: 2,
    box: [-1, -1, 1, 1] as [number, number, number, number],
    moves,
    kb: 0,
    ke: 5,
    delta: 0.6,
    spin: "none" as const,
    continuity: "auto" as const,
    superposed: true,
    ...more,
  };
}

function pairs(flat: Float64Array): [number, number][] {
  return Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i] ?? NaN, flat[2 * i + 1] ?? NaN]);
}

/** How far points are from a closed polyline, at most. */
function off(points: [number, number][], line: [number, number][]): number {
  const to = ([x, y]: [number, number]) =>
    Math.min(
      ...line.map(([ax, ay], i) => {
        const [bx, by] = line[(i + 1) % line.length] ?? [ax, ay];
        const along = (bx - ax) ** 2 + (by - ay) ** 2;
        const share =
          along > 0 ? Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / along)) : 0;
        return Math.hypot(x - ax - share * (bx - ax), y - ay - share * (by - ay));
      }),
    );
  return Math.max(...points.map(to));
}

function expectCode(work: () => unknown, code: string): void {
  let thrown: unknown;
  try {
    work();
  } catch (error) {
    thrown = error;
  }
  expect(thrown).toMatchObject({ code });
  expect((thrown as Error).message.length).toBeGreaterThan(20);
}

beforeAll(() =>
  init({
    frond: read("frond_bg.wasm"),
    curve: read("frond-curve_bg.wasm"),
    proof: read("frond-proof_bg.wasm"),
  }),
);

describe("closed curves", () => {
  it("come with a gallery that packs and comes back", () => {
    const presets = frond.curvePresets();
    expect(presets.map(({ id }) => id)).toEqual(["sugar-maple", "white-oak", "snowflake", "island"]);
    for (const { curve, about } of presets) {
      expect(about.length).toBeGreaterThan(20);
      const text = frond.packCurve(curve);
      expect(text).toMatch(/^[\w-]+$/);
      expect(text.length).toBeLessThan(4000);
      const kept = frond.quantised(curve);
      expect(frond.unpackCurve(text)).toEqual(kept);
      expect(frond.quantised(kept)).toEqual(kept);
      expect(frond.packCurve(kept)).toBe(text);
      const facts = frond.curveFacts(curve);
      expect(facts.knots).toBe(curve.knots.length);
      expect(facts.numbers).toBe(2 * (facts.knots + facts.copies));
      expect(facts.contractivity).toBeLessThanOrEqual(0.9000001);
      expect(facts.bytes).toBe(Math.floor((text.length * 3) / 4));
    }
  });

  it("are described: the snowflake", () => {
    const snowflake = frond.curvePresets().find(({ id }) => id === "snowflake")?.curve as Curve;
    const facts = frond.curveFacts(snowflake);
    expect(facts).toMatchObject({ knots: 12, copies: 12 });
    expect(facts.contractivity).toBeCloseTo(1 / 3, 9);
    expect(Math.abs(facts.dimension - Math.log(4) / Math.log(3))).toBeLessThan(0.1);
  });

  it("are made by their maps", () => {
    const curve = hexagon();
    const maps = frond.curveMaps(curve);
    expect(maps.map(({ map }) => map === null)).toEqual([false, true, true, true, true, true]);
    expect(maps[0]).toMatchObject({ arc: [2, 3], reversed: true });
    expect(maps[3]).toEqual({ map: null, arc: [3, 1], reversed: false });
    const [a, b, c, d, e, f] = maps[0]?.map ?? [0, 0, 0, 0, 0, 0];
    const image = ([x, y]: [number, number]): [number, number] => [a * x + b * y + e, c * x + d * y + f];
    // The far end of the arc comes to lie where the edge begins.
    const [p, q] = [curve.knots[5], curve.knots[2]].map((knot) => image(knot ?? [NaN, NaN]));
    expect(off([p ?? [9, 9]], [curve.knots[0] ?? [0, 0]])).toBeLessThan(1e-12);
    expect(off([q ?? [9, 9]], [curve.knots[1] ?? [0, 0]])).toBeLessThan(1e-12);
  });

  it("become files", () => {
    const svg = frond.curveSvg(hexagon(0.3), { size: 500, tolerance: 0.1, fill: "#00aa00" });
    expect(svg).toMatch(/^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" viewBox="0 0 500 \d+"/);
    expect(svg.match(/<path /g)).toHaveLength(1);
    expect(svg).toMatch(/ d="M[^"]+z"\/>\n<\/svg>\n$/);
    expect(frond.curveSvg(hexagon(), undefined)).toContain('fill="#000000"');
    const rows = frond.curveCsv(hexagon(), { points: 100 }).trim().split("\n");
    expect(rows).toHaveLength(101);
    expect(rows[0]).toBe("x,y");
    expect(rows[1]?.split(",").map(Number)[0]).toBeCloseTo(1, 5);
    for (const fill of ["red", '#12345"', "url(#x)"]) {
      expectCode(() => frond.curveSvg(hexagon(), { fill }), "bad-input");
    }
    for (const size of [Number.NaN, 0, -1, 1e9])
      expectCode(() => frond.curveSvg(hexagon(), { size }), "bad-input");
    for (const tolerance of [Number.NaN, 0, 1e9]) {
      expectCode(() => frond.curveSvg(hexagon(), { tolerance }), "bad-input");
    }
    for (const points of [Number.NaN, 2, 1e9])
      expectCode(() => frond.curveCsv(hexagon(), { points }), "bad-input");
  });

  it("say what is wrong with them", () => {
    const edge = { from: 2, span: 3, reversed: true, c: 0.1 };
    const broken = (change: (curve: Curve) => void) => {
      const curve = hexagon();
      change(curve);
      return curve;
    };
    const cases: [unknown, string][] = [
      [undefined, "bad-input"],
      [{}, "bad-input"],
      [{ knots: "none", edges: [] }, "bad-input"],
      [{ knots: [[0, 0], [1, 0], null], edges: [null, null, null] }, "bad-input"],
      [{ knots: [], edges: [] }, "too-few-points"],
      [{ knots: new Array(1_000_000), edges: [] }, "too-many-knots"],
      [{ knots: [], edges: new Array(1_000_000) }, "too-many-knots"],
      [broken((curve) => curve.edges.pop()), "wrong-count"],
      [broken((curve) => curve.knots.splice(1, 1, [Number.NaN, 0])), "not-finite"],
      [broken((curve) => curve.knots.splice(1, 1, [0, 1e300])), "not-finite"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, c: Number.POSITIVE_INFINITY })), "not-finite"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, c: 5 })), "not-contractive"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, from: 6 })), "bad-arc"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, span: 1 })), "bad-arc"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, span: 9 })), "bad-arc"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, from: -1 })), "bad-input"],
      [broken((curve) => curve.edges.splice(0, 1, { ...edge, span: 2.5 })), "bad-input"],
    ];
    for (const [curve, code] of cases) {
      for (const work of [frond.packCurve, frond.quantised, frond.curveFacts, frond.curveMaps]) {
        expectCode(() => work(curve as Curve), code);
      }
      expectCode(() => frond.curveSvg(curve as Curve, undefined), code);
      expectCode(() => new frond.CurveMorph(curve as Curve, null), code);
      if (curve !== undefined) expectCode(() => new frond.CurveMorph(hexagon(), curve as Curve), code);
    }
    for (const text of ["", "A", "not a curve", "____", "A".repeat(1_000_000)]) {
      expect(() => frond.unpackCurve(text)).toThrowError();
    }
  });
});

describe("a morph of closed curves", () => {
  it("is the first at 0 and the second at 1", () => {
    const presets = frond.curvePresets();
    const [maple, oak] = ["sugar-maple", "white-oak"].map(
      (id) => presets.find((one) => one.id === id)?.curve as Curve,
    );
    if (!maple || !oak) throw new Error("leaves are missing");
    const morph = new frond.CurveMorph(maple, oak);
    for (const [s, curve] of [
      [0, maple],
      [1, oak],
    ] as const) {
      const alone = new frond.CurveMorph(curve, null);
      const [left, bottom, right, top] = morph.bounds(s);
      const tolerance = Math.hypot(right - left, top - bottom) / 400;
      const [line, wanted] = [morph, alone].map((one) => pairs(one.polyline(s, { tolerance })));
      expect(off(line ?? [], wanted ?? [])).toBeLessThan(2.1 * tolerance);
      expect(off(wanted ?? [], line ?? [])).toBeLessThan(2.1 * tolerance);
      expect(off(curve.knots, line ?? [])).toBeLessThan(1.1 * tolerance);
      alone.free();
    }
    const facts = morph.facts(0.5);
    expect(facts.ratio).toBeLessThan(1);
    expect(facts.knots).toBeGreaterThanOrEqual(Math.max(maple.knots.length, oak.knots.length));
    expect(facts.dimension).toBeGreaterThan(0.9);
    expect(facts.crossings).toBeGreaterThanOrEqual(0);
    morph.free();
  });

  it("holds to the window, to the most points, and to what it is told of a bend", () => {
    const snowflake = frond.curvePresets().find(({ id }) => id === "snowflake")?.curve as Curve;
    const rough = new frond.CurveMorph(snowflake, null);
    const [left, bottom] = rough.bounds(0);
    const fine = rough.polyline(0, { tolerance: 1e-4 });
    const part = rough.polyline(0, { tolerance: 1e-4, window: [left, bottom, left + 0.1, bottom + 0.1] });
    expect(part.length * 4).toBeLessThan(fine.length);
    rough.free();
    const morph = new frond.CurveMorph(hexagon(), null);
    const all = morph.polyline(0, { tolerance: 1e-4 });
    expect(morph.polyline(0, { tolerance: 0, most: 100 }).length).toBeLessThanOrEqual(200);
    const still = new Array<number>(8).fill(0);
    const rest = morph.polyline(0, { tolerance: 1e-3, bend: bend(still) });
    expect(off(pairs(rest), pairs(all))).toBeLessThan(2e-3);
    const aside = morph.polyline(0, { tolerance: 1e-3, bend: bend([1, 2, 1, 2, 1, 2, 1, 2]) });
    const back = pairs(aside).map(([x, y]): [number, number] => [x - 1, y - 2]);
    expect(off(back, pairs(all))).toBeLessThan(2e-3);
    // The same whether it was moved there or made there.
    const lifted = bend([0, 0, 0, 0, 0, 0.5, 0, 0]);
    const moved = morph.polyline(0, { tolerance: 1e-3, bend: lifted });
    const other = new frond.CurveMorph(hexagon(), null);
    expect(other.polyline(0, { tolerance: 1e-3, bend: lifted })).toEqual(moved);
    // Plain where nothing is shuffled.
    const plain = pairs(morph.polyline(0, { tolerance: 1e-3, bend: bend(lifted.moves, { kb: 5 }) }));
    const [x, y] = [(1 - -1) / 2, (Math.sqrt(3) / 2 + 1) / 2];
    expect(x).toBe(1);
    const knot = hexagon().knots[1] ?? [0, 0];
    const share = ((1 - knot[0]) / 2) * y;
    expect(off([[knot[0], knot[1] + 0.5 * share]], plain)).toBeLessThan(3e-3);
    morph.free();
    other.free();
  });

  it("says what is wrong with a view", () => {
    const morph = new frond.CurveMorph(hexagon(), null);
    for (const view of [undefined, {}, { tolerance: "1" }, { tolerance: Number.NaN }, { tolerance: -1 }]) {
      expectCode(() => morph.polyline(0, view as never), "bad-input");
    }
    for (const window of [
      [1, 0, 0, 1],
      [0, 0, Number.NaN, 1],
      [0, 0, 1],
    ]) {
      expectCode(() => morph.polyline(0, { tolerance: 0.1, window: window as never }), "bad-input");
    }
    for (const most of [0, 2, Number.NaN, 1e12]) {
      expectCode(() => morph.polyline(0, { tolerance: 0.1, most }), "bad-input");
    }
    for (const s of [Number.NaN, Number.POSITIVE_INFINITY]) {
      expectCode(() => morph.polyline(s, { tolerance: 0.1 }), "bad-input");
      expectCode(() => morph.bounds(s), "bad-input");
      expectCode(() => morph.facts(s), "bad-input");
    }
    const bends: [object, string][] = [
      [bend([]), "mesh-count"],
      [bend(new Array(8).fill(Number.NaN)), "mesh-numbers"],
      [bend(new Array(8).fill(0), { kb: 7 }), "bend-locality"],
      [bend(new Array(8).fill(0), { delta: -1 }), "bend-roughness"],
      [{}, "bad-input"],
    ];
    for (const [wrong, code] of bends) {
      // After a good one, too: what is kept of it must not let a bad one pass.
      expectCode(() => morph.polyline(0, { tolerance: 0.1, bend: wrong as never }), code);
      morph.polyline(0, { tolerance: 0.1, bend: bend(new Array(8).fill(0.1)) });
      expectCode(() => morph.polyline(0, { tolerance: 0.1, bend: wrong as never }), code);
    }
    expect(morph.polyline(-3, { tolerance: 0.1 })).toEqual(morph.polyline(7, { tolerance: 0.1 }));
    morph.free();
  });
});
