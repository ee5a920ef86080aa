import { describe, expect, it } from "vitest";
import type { Graph } from "#wasm/api";
import {
  asKind,
  errorsOf,
  evaluator,
  type Model,
  modelOf,
  rangeOf,
  request,
  short,
  withKnot,
  withKnotIn,
  withoutKnot,
} from "./model";

/** Fig 1: (0, 0), (0.5, 1), (1, 0) with 0.6 and 0.4. */
const fig1: Graph = {
  kind: "fif",
  pieces: [
    { map: [0.5, 1, 0.6, 0, 0], domain: [0, 1] },
    { map: [0.5, -1, 0.4, 0.5, 1], domain: [0, 1] },
  ],
};

const four: Model = {
  kind: "rfif",
  knots: [
    [0, 0],
    [1, 2],
    [2, 1],
    [4, 0],
  ],
  parts: [
    { c: 0.5, reflected: false, domain: [1, 4] },
    { c: 0.4, reflected: true, domain: [0, 2] },
    { c: -0.3, reflected: false, domain: [0, 4] },
  ],
};

describe("evaluator", () => {
  it("goes through the knots and obeys its own maps", () => {
    const at = evaluator(fig1);
    expect(at(0)).toBeCloseTo(0, 12);
    expect(at(0.5)).toBeCloseTo(1, 12);
    expect(at(1)).toBeCloseTo(0, 12);
    for (const t of [0.1, 0.37, 0.8]) {
      expect(at(t / 2)).toBeCloseTo(t + 0.6 * at(t), 12);
      expect(at(0.5 + t / 2)).toBeCloseTo(-t + 0.4 * at(t) + 1, 12);
    }
  });

  it("takes reflected pieces the other way round, and t beyond the ends to the ends", () => {
    const mirrored: Graph = {
      kind: "fif",
      pieces: [
        { map: [-0.5, -1, 0.6, 0.5, 1], domain: [0, 1] },
        { map: [0.5, -1, 0.4, 0.5, 1], domain: [0, 1] },
      ],
    };
    expect(rangeOf(mirrored.pieces[0] as Graph["pieces"][number])).toEqual([0, 0.5]);
    const at = evaluator(mirrored);
    expect(at(0)).toBeCloseTo(0, 12);
    expect(at(0.25)).toBeCloseTo(-0.5 + 0.6 * at(0.5) + 1, 12);
    expect(at(-3)).toBe(at(0));
    expect(at(9)).toBe(at(1));
  });
});

describe("modelOf", () => {
  it("reads knots, roughness and what is copied", () => {
    const model = modelOf(fig1, evaluator(fig1));
    expect(model.knots).toEqual([
      [0, 0],
      [0.5, 1],
      [1, 0],
    ]);
    expect(model.parts.map(({ c }) => c)).toEqual([0.6, 0.4]);
    expect(request(model)).toEqual({
      points: model.knots,
      options: { c: [0.6, 0.4], reflected: [false, false] },
    });
  });
});

describe("withKnot", () => {
  it("takes along the domains that end there, and stops before its neighbours", () => {
    const moved = withKnot(four, 1, [1.5, 7]);
    expect(moved.knots[1]).toEqual([1.5, 7]);
    expect(moved.parts.map(({ domain }) => domain)).toEqual([
      [1.5, 4],
      [0, 2],
      [0, 4],
    ]);
    expect(withKnot(four, 1, [99, 2]).knots[1]?.[0]).toBeLessThan(2);
    expect(withKnot(four, 1, [-99, 2]).knots[1]?.[0]).toBeGreaterThan(0);
    expect(withKnot(four, 1, [Number.NaN, 2])).toBe(four);
    expect(withKnot(four, 9, [1, 1])).toBe(four);
    expect(withKnot(four, 1, [1, 2])).toBe(four);
  });

  it("moves an end with all that copies the whole", () => {
    const wider = withKnot(four, 3, [5, 0]);
    expect(wider.parts.map(({ domain }) => domain[1])).toEqual([5, 2, 5]);
    const narrower = withKnot({ ...four, kind: "pfif" }, 3, [3, 0]);
    expect(narrower.parts[0]?.domain).toEqual([1, 3]);
  });
});

describe("knots more and less", () => {
  it("splits a piece where the graph is", () => {
    const more = withKnotIn(four, 2, () => 0.25);
    expect(more.knots[3]).toEqual([3, 0.25]);
    expect(more.parts).toHaveLength(4);
    expect(more.parts[3]).toEqual(four.parts[2]);
    expect(withKnotIn(four, 7, () => 0)).toBe(four);
  });

  it("takes domains that ended there to a neighbour", () => {
    const less = withoutKnot(four, 1);
    expect(less.knots).toHaveLength(3);
    expect(less.parts.map(({ c }) => c)).toEqual([0.5, -0.3]);
    expect(less.parts[0]?.domain).toEqual([0, 4]);
    expect(withoutKnot(four, 0)).toBe(four);
    expect(withoutKnot(four, 3)).toBe(four);
  });

  it("never leaves a piece that is longer than what it copies", () => {
    const kept = withoutKnot({ ...four, kind: "pfif" }, 2);
    for (const [i, { domain }] of kept.parts.entries()) {
      const long = (kept.knots[i + 1]?.[0] ?? 0) - (kept.knots[i]?.[0] ?? 0);
      expect(domain[1] - domain[0]).toBeGreaterThan(long);
    }
  });
});

describe("asKind", () => {
  it("copies all as FIF, from knot to knot as RFIF, and the same as PFIF", () => {
    expect(asKind(four, "fif").parts.every(({ domain }) => domain[0] === 0 && domain[1] === 4)).toBe(true);
    const parted = asKind(four, "pfif");
    expect(parted.parts).toEqual(four.parts);
    const between = {
      ...parted,
      parts: parted.parts.map((part, i) =>
        i === 0 ? { ...part, domain: [0.9, 3.8] as [number, number] } : part,
      ),
    };
    expect(asKind(between, "rfif").parts[0]?.domain).toEqual([1, 4]);
    expect(request(asKind(between, "rfif")).options.spans?.[0]).toEqual([1, 3]);
  });
});

it("measures points by their distance from the graph", () => {
  const { worst, meanSquare, where } = errorsOf([0, 0, 1, 3, 2, 1], () => 1);
  expect([worst, where]).toEqual([2, 1]);
  expect(meanSquare).toBeCloseTo((1 + 4 + 0) / 3, 12);
  expect(errorsOf([], () => 0).meanSquare).toBe(0);
});

it("leaves out digits that nobody sees, whatever the units", () => {
  const third = 1 / 3;
  const graph: Graph = {
    kind: "pfif",
    pieces: [
      { map: [third, 1e-14, 0.5, 2000 - 2000 * third, 1e6 / 3], domain: [2000, 2024] },
      { map: [2 * third, 2e-5 / 3, -0.25, 2008 - 4000 * third, 1e6 / 7], domain: [2000, 2024] },
    ],
  };
  const [one, two] = short(graph).pieces;
  expect(String(one?.map[4])).toBe("333333.33333");
  expect(one?.map[1]).toBe(0);
  expect(String(two?.map[0]).length).toBeLessThan(16);
  // Pieces still meet, and heights are the same.
  const ends = short(graph).pieces.map(rangeOf);
  expect(Math.abs((ends[0]?.[1] ?? 0) - (ends[1]?.[0] ?? 0))).toBeLessThan(1e-10 * 24);
  const [at, before] = [evaluator(short(graph)), evaluator(graph)];
  expect(Math.abs(at(2000) - before(2000)) / 1e6).toBeLessThan(1e-5);
  const plain = short({
    kind: "fif",
    pieces: [{ map: [third, -1e-16, 0.1 + 0.2, 0, third], domain: [0, 1] }],
  });
  expect(plain.pieces[0]?.map).toEqual([0.33333333333, 0, 0.3, 0, 0.33333333333]);
});
