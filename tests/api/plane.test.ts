import { beforeAll, describe, expect, it } from "vitest";
import * as frond from "../../www/pkg/index.js";
import { load, refused, shape, wrong } from "./frond";

beforeAll(load);

const states = (tile: { state: Uint8Array }) => Array.from(tile.state, (state) => state < 2);

describe("a shape", () => {
  it("is validated with stable codes", () => {
    expect(() => frond.validate(shape("fern"))).not.toThrow();
    for (const [ifs, code] of [
      [{ maps: [] }, "no-maps"],
      [{ maps: [[1, 0, 0, 1, 0, 0]] }, "no-attractor"],
      [{ maps: [[1e300, 0, 0, 1, 0, 0]] }, "not-finite"],
      [{ maps: [[1, 2, 3]] }, "bad-input"],
      [{ maps: "none" }, "bad-input"],
      [{}, "bad-input"],
      [[], "bad-input"],
      [{ maps: [[0.5, 0, 0, 0.5, 0, 0]], probabilities: [1, 2] }, "probabilities"],
      [undefined, "bad-input"],
      [null, "bad-input"],
      [5, "bad-input"],
      ["x", "bad-input"],
      [{ maps: new Array(1_000_000) }, "too-many-maps"],
    ] as const)
      expect(refused(() => frond.validate(wrong(ifs)))).toBe(code);
  });

  it("has as many points by the chaos game as were asked for", () => {
    const { positions, pieces } = frond.attractor(shape("fern"), { points: 1000, seed: 5 });
    expect([positions.length, pieces.length]).toEqual([2000, 1000]);
    expect(positions.every((x) => Math.abs(x) < 11)).toBe(true);
    for (const bad of [{ points: -1 }, { points: 1e12 }, {}])
      expect(refused(() => frond.attractor(shape("fern"), wrong(bad)))).toBe("bad-input");
  });

  it("takes a field that is undefined as one that is absent", () => {
    const gasket = shape("gasket");
    const absent = { probabilities: undefined, seed: undefined, w: undefined };
    expect(frond.attractor(wrong({ ...gasket, ...absent }), wrong({ points: 9, ...absent }))).toEqual(
      frond.attractor(gasket, { points: 9 }),
    );
    expect(frond.interpolate(gasket, gasket, wrong({ u: 0, v: 0.5, ...absent })).maps).toHaveLength(3);
    expect(() => frond.attractor(gasket, wrong({ points: undefined }))).toThrow(
      "The options cannot be read: missing field `points`.",
    );
  });

  it("is moved by conjugation", () => {
    const { min, dimension } = frond.bounds(frond.conjugate(shape("gasket"), [2, 0, 0, 2, 5, 7]));
    expect(Math.abs(min[0] - 5)).toBeLessThan(0.02);
    expect(Math.abs(min[1] - 7)).toBeLessThan(0.02);
    expect(dimension).toBeCloseTo(Math.log2(3), 9);
    expect(refused(() => frond.conjugate(shape("gasket"), [0, 0, 0, 0, 0, 0]))).toBe("singular");
  });

  it("has maps with polar factors", () => {
    const { angle, reflects } = frond.polar([0, -0.5, 0.5, 0, 0, 0]);
    expect(angle).toBeCloseTo(Math.PI / 2, 12);
    expect(reflects).toBe(false);
  });

  it("goes through a link, with all of the document", () => {
    const scene = frond.defaultScene();
    expect(frond.decodeScene(frond.encodeScene(scene))).toEqual({ scene });
    const damaged = frond.decodeScene("a=%00&b=<script>");
    expect(damaged.problem?.code).toBe("link-damaged");
    expect(damaged.scene).toEqual(scene);
  });
});

describe("a verdict", () => {
  it("says what it knows", () => {
    expect(frond.connectedness(shape("dragon"), undefined).verdict).toBe("connected");
    const doubled = { maps: [[2, 0, 0, 2, 0, 0]] } as frond.Ifs;
    expect(frond.connectedness(doubled, undefined).verdict).toBe("no-attractor");
    const dust = frond.connectedness(shape("dust"), undefined);
    expect(dust).toMatchObject({ verdict: "disconnected", count: 4 });
    expect(dust).not.toHaveProperty("reason");
    // Ratio 0.4 in the unit square: pieces are 0.2 apart.
    expect(Math.abs(dust.gap.upper - 0.2)).toBeLessThan(0.005);
  });

  it("comes with a reason, or with what it hangs on", () => {
    const gasket = frond.connectedness(shape("gasket"), undefined);
    expect(gasket.verdict).toBe("connected");
    expect(gasket.reason).toMatchObject({ kind: "shared-points", assuming: [] });
    expect(gasket.reason?.text.length).toBeGreaterThan(20);
    expect(gasket.reason?.links).toHaveLength(2);
    const first = { kind: "point", pair: [0, 1], words: ["1(2)", "2(1)"], at: [0.5, 0] };
    expect(gasket.reason?.links[0]).toEqual(first);
    expect(gasket).not.toHaveProperty("closest");
    const koch = frond.connectedness(shape("koch"), undefined);
    expect(koch.verdict).toBe("touching");
    expect(koch.reason?.assuming[0]).toBe("0.3333333333333333 is 1/3");
    expect(koch.closest).toBeTypeOf("object");
  });

  it("has a certificate that is checked, and refused once it is changed", () => {
    const certificate = frond.certificate(shape("dust"), undefined);
    if (!certificate) throw new Error("dust has a certificate");
    const { pairs } = certificate;
    expect(frond.checkCertificate(certificate)).toMatchObject({ valid: true, pairs: pairs.length });
    // Saved and read again, it is the same to the last digit.
    expect(frond.checkCertificate(JSON.parse(JSON.stringify(certificate))).valid).toBe(true);
    const changed = frond.checkCertificate(
      wrong({ ...certificate, pairs: pairs.with(0, wrong({ ...pairs[0], normal: [0, 0] })) }),
    );
    expect(changed.valid).toBe(false);
    expect(changed.text).toContain("not apart");
    for (const nothing of [undefined, {}, [], { maps: [[1]] }, 5])
      expect(frond.checkCertificate(wrong(nothing)).valid).toBe(false);
    // What is in one piece has none, but one of another kind.
    expect(frond.certificate(shape("gasket"), undefined)).toBeNull();
    expect(frond.connectedCertificate(shape("dust"), undefined)).toBeNull();
    expect(() => frond.certificate({ maps: [[2, 0, 0, 2, 0, 0]] }, undefined)).toThrow();
  });
});

describe("a shape that is in one piece", () => {
  it("has a certificate that is checked, and refused once it is changed", () => {
    for (const [id, kind] of [
      ["gasket", "point"],
      ["maple", "crossing"],
    ] as const) {
      const certificate = frond.connectedCertificate(shape(id), undefined);
      if (!certificate) throw new Error(`${id} has a certificate`);
      const { links } = certificate;
      expect(links.map((link) => link.kind)).toContain(kind);
      const expected = { valid: true, pairs: 0, links: links.length };
      expect(frond.checkCertificate(certificate)).toMatchObject(expected);
      expect(frond.checkCertificate(JSON.parse(JSON.stringify(certificate)))).toMatchObject(expected);
      const changed = frond.checkCertificate({ ...certificate, links: links.slice(1) });
      expect(changed).toMatchObject({ valid: false, links: 0 });
      expect(changed.text).toContain("do not reach all pieces");
    }
    // A turned square of nine copies, each by a multiple of a quarter: they do not cross.
    const row = (k: number): [number, number, number, number, number, number] => [
      0.4,
      -0.31,
      0.31,
      0.4,
      (k % 3) / 4,
      k / 12,
    ];
    const turned = { maps: Array.from({ length: 9 }, (_, k) => row(k)) };
    expect(frond.connectedness(turned, undefined).reason?.kind).toBe("differences");
    const squares = frond.connectedCertificate(turned, undefined);
    expect(squares && frond.checkCertificate(JSON.parse(JSON.stringify(squares)))).toMatchObject({
      valid: true,
    });
    for (const nothing of [{ links: 5 }, { links: [] }, { links: [{ kind: "faith" }], maps: [] }])
      expect(frond.checkCertificate(wrong(nothing)).valid).toBe(false);
  });
});

describe("a morph", () => {
  it("starts and ends where it should", () => {
    const { from, to, steps } = frond.pair(shape("dragon"), shape("gasket"));
    expect(steps).toHaveLength(1);
    const end = frond.interpolate({ maps: from }, { maps: to }, { u: 1, v: 1 });
    expect(end.maps).toEqual(to);
    const uneven = () => frond.interpolate(shape("dragon"), shape("gasket"), { u: 1, v: 1 });
    expect(refused(uneven)).toBe("map-counts");
  });

  it("has a locus that holds both ends, whole or in tiles", () => {
    const [from, to] = [shape("dragon-3"), shape("gasket")];
    const size = { width: 13, height: 13 };
    const { state } = frond.locus(from, to, size);
    // (0, 0) and (1, 1) are samples 4 and 8 of 13.
    expect(state[4 * 13 + 4]).toBeLessThanOrEqual(1);
    expect(state[8 * 13 + 8]).toBeLessThanOrEqual(1);
    expect(state).toContain(2);
    const tiles = new frond.LocusTiles(from, to, size);
    const pieced = new Uint8Array(169).fill(255);
    for (const [stride, first] of [
      [4, true],
      [2, false],
      [1, false],
    ] as const) {
      for (const [i, seen] of tiles.run(0, 13, stride, first).state.entries())
        if (seen !== 255) pieced[Math.floor(i / 13) * stride * 13 + (i % 13)] = seen;
    }
    expect(pieced).toEqual(state);
    for (const bad of [
      { width: 0, height: 5 },
      { width: 1e9, height: 5 },
      { width: -1, height: 1 },
    ])
      expect(refused(() => frond.locus(from, to, bad))).toBe("locus-size");
  });

  it("proves what only seemed to touch, and refuses states of another size", () => {
    const options = { width: 40, height: 40, epsilon: 1e-4 };
    const tiles = new frond.LocusTiles(shape("dragon-3"), shape("gasket"), options);
    const { state } = tiles.patch(0, 0, 40, 40);
    const proved = tiles.prove(0, 0, 40, 40, state);
    const count = (all: Uint8Array, s: number) => all.filter((x) => x === s).length;
    expect(count(proved, 0)).toBeGreaterThan(4 * count(proved, 1));
    expect(count(proved, 0) + count(proved, 1)).toBe(count(state, 0) + count(state, 1));
    expect(refused(() => tiles.prove(0, 0, 40, 40, state.slice(1)))).toBe("bad-input");
    const polygons = new frond.FamilyTiles(
      { sides: 2 },
      { width: 9, height: 9, bounds: { u0: 0.3, v0: 0.3, u1: 0.7, v1: 0.7 } },
    );
    expect(polygons.prove(2, 2, 4, 4, polygons.patch(2, 2, 4, 4).state)).toHaveLength(4);
  });

  it("has patches that agree with rows, and so have families", () => {
    const size = { width: 25, height: 22 };
    const tiles = (more: object) =>
      new frond.LocusTiles(shape("dragon-3"), shape("gasket"), { ...size, ...more });
    for (const more of [{}, { w: 0.25 }]) {
      const both = tiles(more);
      const rows = states(both.run(0, 22, 1, true));
      expect(states(both.patch(0, 0, 25, 22))).toEqual(rows);
      const part = states(both.patch(3, 5, 10, 9));
      expect(part).toEqual(
        Array.from({ length: 28 }, (_, k) => rows[(5 + Math.floor(k / 7)) * 25 + 3 + (k % 7)]),
      );
    }
    expect(refused(() => tiles({ w: "far" }))).toBe("bad-input");
    const bounds = { u0: -0.75, v0: 0, u1: 0.75, v1: 0.75 };
    const family = (sides: unknown) => new frond.FamilyTiles(wrong({ sides }), { ...size, bounds });
    const set = family(2);
    const rows = states(set.run(0, 22, 1, true));
    expect(states(set.patch(0, 0, 25, 22))).toEqual(rows);
    expect([rows[0], rows[12]], "s = -0.75 holds and s = 0 does not").toEqual([true, false]);
    for (const sides of [1, 2.5, 65, "two", null]) expect(refused(() => family(sides))).toBe("bad-input");
    expect(frond.criticalScale(6)).toBeCloseTo(1 / 3, 15);
    expect(refused(() => frond.criticalScale(Number.NaN))).toBe("bad-input");
    expect(frond.familyMaps({ sides: 2 }, [0.5, 0.25]).maps).toEqual([
      [0.5, -0.25, 0.25, 0.5, 1, 0],
      [0.5, -0.25, 0.25, 0.5, -1, 0],
    ]);
    expect(refused(() => frond.familyMaps({ sides: 2 }, wrong([0.5])))).toBe("bad-input");
  });
});

describe("a path", () => {
  const ends = () => [shape("terdragon-mirrored"), shape("gasket")] as const;

  it("is found along a third axis where the plane has none", () => {
    const plane = frond.planPath(...ends(), { size: 31 });
    expect(plane.holds).toBe(false);
    expect(plane.worst).toHaveLength(2);
    const space = frond.planPath(...ends(), { size: 31, axes: 3 });
    expect(space.holds).toBe(true);
    expect(space).not.toHaveProperty("worst");
    expect(space.clearance).toBeGreaterThan(0);
    expect([space.points[0], space.points.at(-1)]).toEqual([
      [0, 0],
      [1, 1],
    ]);
    expect(space.points.some((point) => point.length === 3)).toBe(true);
    // What comes out goes in.
    expect(frond.checkPath(...ends(), space.points, { samples: 801 }).holds).toBe(true);
    expect(refused(() => frond.planPath(...ends(), wrong({ axes: 4 })))).toBe("bad-input");
    for (const bad of [[], [[0, 0], [1]], [[0, 0, 0, 0]], [[0, null]], [0, 1]])
      expect(refused(() => frond.checkPath(...ends(), wrong(bad), undefined))).toBe("bad-input");
  });

  it("is proved a stretch at a time", () => {
    const prove = (points: unknown, options: unknown) =>
      frond.certifyPath(shape("gasket"), shape("gasket"), wrong(points), wrong(options));
    const still = prove(
      [
        [0, 0],
        [1, 1],
      ],
      { within: 1e-4 },
    );
    expect(still).toMatchObject({ holds: true, complete: true });
    expect(still.gap).toBeLessThanOrEqual(1e-4);
    const part = prove(
      [
        [0, 0],
        [0.5, 0.2, 0.1],
        [1, 1],
      ],
      { t0: 0.25, t1: 0.5, budget: 50 },
    );
    expect(part.worst).toBeGreaterThanOrEqual(0.25);
    expect(part.worst).toBeLessThanOrEqual(0.5);
    for (const [points, options] of [
      [[[0]], {}],
      [[[0, 0, 0, 0]], {}],
      [5, {}],
      [[], { within: "x" }],
      [[], {}],
      [[[0, 0]], { t0: 0.7, t1: 0.2 }],
      [[[0, 0]], { t0: 2, t1: 3 }],
      [[[0, 0]], { t0: Number.NaN }],
    ])
      expect(refused(() => prove(points, options))).toBe("bad-input");
  });

  it("is rated with each way to match the maps", () => {
    const ends = [shape("terdragon"), shape("gasket")] as const;
    const list = frond.candidates(...ends, { limit: 5 });
    expect(list).toHaveLength(5);
    const best = list[0];
    if (!best) throw new Error("there is a best one");
    const rated = frond.rateCandidate(...ends, wrong({ ...best, size: 13 }));
    expect(rated).toMatchObject({ correspondence: best.correspondence, turns: best.turns, cost: best.cost });
    expect(rated.share).toBeGreaterThan(0.1);
    expect(rated.share).toBeLessThan(1);
    expect(rated.locus.state).toHaveLength(169);
    expect(rated.plan.points.length).toBeGreaterThanOrEqual(2);
    expect(refused(() => frond.rateCandidate(...ends, { turns: [99, 0, 0] }))).toBe("turns");
    expect(refused(() => frond.candidates(shape("dragon"), shape("gasket"), undefined))).toBe("map-counts");
  });

  it("has routes, which are explained", () => {
    const kinds = (from: string, to: string) =>
      frond.routes(shape(from), shape(to)).map((route) => {
        expect(route.about).toMatch(/\.$/);
        expect(route.from).toHaveLength(route.to.length);
        return route.kind;
      });
    expect(kinds("fern", "maple")).toEqual(["collapse", "symmetry"]);
    expect(kinds("dragon", "gasket")[0]).toBe("refine");
  });

  it("says how probable the maps of a route are", () => {
    const heavy = { ...shape("dragon"), probabilities: [3, 1] };
    const rounded = (list: number[]) => list.map((p) => Number(p.toFixed(9))).sort();
    for (const [route] of [
      frond.routes(heavy, shape("gasket")),
      frond.ways(heavy, shape("gasket"), { limit: 1 }),
    ]) {
      expect(rounded(route?.fromProbabilities ?? [])).toEqual([0.1875, 0.25, 0.5625]);
      expect(rounded(route?.toProbabilities ?? [])).toEqual([0.333333333, 0.333333333, 0.333333333]);
    }
  });
});
