import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as directed from "../../www/pkg/frond-directed.js";

/** What docs/package.md promises of `frond-ifs/directed`. */
const PROMISED = `directedPresets outlineShape directedFacts directedAttractor rasterizeDirected directedConnectedness DirectedLocus
  matchDirected interpolateDirected certifyDirected digitShape gridIntersection`;

type System = Parameters<typeof directed.directedFacts>[0];

const half = (from: number, x: number, y: number) => ({
  from,
  map: [0.5, 0, 0, 0.5, x, y] as [number, number, number, number, number, number],
});
const preset = (id: string): System => {
  const found = directed.directedPresets().find((one) => one.id === id);
  if (found === undefined) {
    throw new Error(`no preset ${id}`);
  }
  return found.system;
};
const refused = (run: () => unknown): string => {
  try {
    run();
    return "";
  } catch (problem) {
    const { code, message } = problem as { code: string; message: string };
    return `${code}: ${message}`;
  }
};

describe("graph-directed systems", () => {
  beforeAll(async () => {
    const file = new URL("../../www/pkg/frond-directed_bg.wasm", import.meta.url);
    await init({ module_or_path: await readFile(file) });
  });

  it("have the functions that are promised", () => {
    const missing = PROMISED.split(/\s+/).filter(
      (name) => typeof (directed as Record<string, unknown>)[name] !== "function",
    );
    expect(missing).toEqual([]);
  });

  it("are closed curves, as large as what they become, which a fern becomes in one piece", () => {
    const fern = preset("frond");
    const knots: [number, number][] = Array.from({ length: 24 }, (_, k) => {
      const radius = k % 2 === 0 ? 300 : 180;
      return [radius * Math.cos((Math.PI * k) / 12), radius * Math.sin((Math.PI * k) / 12)];
    });
    const edges = knots.map((_, k) => (k === 5 ? { from: 8, span: 2, reversed: true, c: 0.5 } : null));
    const star = directed.outlineShape("Star", { knots, edges }, [0, 0, 1, 1]);
    expect(star).toMatchObject({ name: "Star", outline: expect.stringMatching(/^[\w-]+$/) });
    const [whole] = directed.directedFacts(star).states;
    expect(whole?.max[1]).toBeCloseTo(1, 2);
    expect(whole?.min[1]).toBeCloseTo(0, 2);
    expect(directed.matchDirected(fern, star).steps).toEqual([
      expect.stringMatching(/parted into 24 stretches/),
    ]);
    expect(directed.certifyDirected(fern, star, { mode: "linear" })).toMatchObject({
      states: expect.arrayContaining([{ kind: "connected" }]),
      assuming: [],
      moments: 0,
    });
    const half = directed.interpolateDirected(fern, star, { u: 0.5, v: 0.5, mode: "linear" });
    expect(directed.directedFacts(half).states.length).toBeGreaterThan(2);
    expect(refused(() => directed.outlineShape("None", { knots: [], edges: [] }))).not.toBe("");
    // Without a box it stays where it is.
    for (const box of [undefined, null]) {
      const [plain] = directed.directedFacts(
        directed.outlineShape("Star", { knots, edges }, box as never),
      ).states;
      expect(plain?.max[1]).toBeGreaterThan(290);
    }
  });

  it("are described, sampled and drawn", () => {
    const flake = preset("snowflake");
    const facts = directed.directedFacts(flake);
    expect(facts).toMatchObject({ unreached: [], neverReturn: [0] });
    expect(facts.states[0]?.dimension).toBeCloseTo(Math.log(4) / Math.log(3), 12);
    expect(facts.states[0]?.max[1]).toBeCloseTo(Math.sqrt(0.75), 2);
    const { positions, pieces } = directed.directedAttractor(flake, { points: 500, seed: 3 });
    expect([positions.length, new Set(pieces).size]).toEqual([1000, 3]);
    const pixels = directed.rasterizeDirected(flake, { width: 40, height: 30, smooth: false });
    expect(pixels.length).toBe(4 * 40 * 30);
    expect(pixels.some((value, i) => i % 4 === 3 && value === 255)).toBe(true);
    expect(refused(() => directed.rasterizeDirected(flake, { width: 9, height: 9, state: 2 }))).toMatch(
      /^state: .* 3\./,
    );
  });

  it("are decided state by state", () => {
    const [left, right] = directed.directedConnectedness(preset("two-dragons"), {});
    expect([left?.verdict, right?.verdict]).toEqual(["connected", "connected"]);
    expect(left?.links[0]?.words).toEqual(["1(2)", "2(1)"]);
  });

  it("are morphed, with graphs matched, and proved on the way", () => {
    const [a, b] = [preset("crystal"), preset("quilt")];
    const match = directed.matchDirected(a, b);
    expect(match.states[0]).toEqual([0, 0]);
    expect(match.steps.length).toBeGreaterThan(0);
    expect(directed.interpolateDirected(a, a, { u: 1, v: 1 })).toEqual(a);
    const middle = directed.interpolateDirected(a, b, { u: 0.5, v: 0.5 });
    expect(middle.states.length).toBe(match.states.length);
    const proof = directed.certifyDirected(a, a, { mode: "linear" });
    expect(proof).toEqual({
      states: [{ kind: "connected" }, { kind: "connected" }],
      assuming: [],
      moments: 0,
    });
  });

  it("are what two shapes of one grid share", () => {
    type Digits = Parameters<typeof directed.gridIntersection>[0];
    const cantor: Digits = {
      matrix: [3, 0, 0, 3],
      digits: [
        [0, 0],
        [2, 0],
      ],
    };
    const at = (p: number, denominator: number, second: Digits = cantor) =>
      directed.gridIntersection(cantor, second, { numerators: [p, 0], denominator });
    const quarter = at(2, 8);
    expect(quarter).toMatchObject({ denominator: 4, shifts: 2, isExact: true, addresses: "uncountable" });
    expect(quarter.states).toEqual([
      {
        shifts: [[1, 0]],
        copies: [
          { digit: 0, to: 1 },
          { digit: 1, to: 1 },
        ],
      },
      { shifts: [[3, 0]], copies: [{ digit: 1, to: 0 }] },
    ]);
    expect(quarter.dimension).toBeCloseTo(Math.log(2) / Math.log(9), 12);
    expect(quarter.attractor?.map((map) => map[0])).toEqual([1 / 9, 1 / 9].map((x) => expect.closeTo(x, 12)));
    expect(directed.directedFacts(quarter.system as System).states[0]?.max[0]).toBeCloseTo(1, 2);
    expect(at(1, 1)).toMatchObject({ addresses: 1, points: [[expect.closeTo(1, 12), 0]] });
    const far = at(3, 2);
    expect(far).toMatchObject({ system: null, states: [], addresses: 0, points: [], attractor: null });
    expect(far.dimension).toBeUndefined();
    const moved = directed.digitShape(cantor, { shift: [2, -1] });
    expect(moved.states[0]?.[0]?.map.slice(4)).toEqual([4 / 3, -2 / 3].map((x) => expect.closeTo(x, 12)));
    expect(refused(() => at(1, 0))).toMatch(/^grid-shift/);
    expect(refused(() => at(0.5, 1))).toMatch(/^bad-input: The shift/);
    expect(refused(() => at(0, 1, { ...cantor, matrix: [2, 0, 0, 2] }))).toMatch(/^grid-matrices/);
    const many = { ...cantor, digits: new Array(1e6).fill([0, 0]) };
    expect(refused(() => at(0, 1, many))).toMatch(/^digits-too-many: There are 1000000/);
    expect(refused(() => directed.digitShape(null as unknown as Digits, {}))).toMatch(/^bad-input/);
  });

  it("have a map of where their morph holds together", () => {
    const options = { mode: "linear", width: 4, height: 4 } as const;
    const map = new directed.DirectedLocus(preset("snowflake"), preset("crystal"), options);
    const { state, gap } = map.run(0, 4, 1);
    map.free();
    expect([state.length, gap.length]).toEqual([16, 16]);
    // Both ends, at (0, 0) and (1, 1), are proved to be in one piece; the corner of no way is not.
    expect([state[5], state[10], state[3]]).toEqual([0, 0, 2]);
    const none = { ...options, width: 0 };
    expect(refused(() => new directed.DirectedLocus(preset("sun"), preset("quilt"), none))).toMatch(
      /^locus-size/,
    );
  });

  it("say what is wrong with them", () => {
    const facts = (states: unknown) => refused(() => directed.directedFacts({ states } as System));
    expect(facts([])).toMatch(/^no-states/);
    expect(facts([[half(0, 0, 0)], []])).toMatch(/^no-maps: State 2/);
    expect(facts([[half(4, 0, 0)]])).toMatch(/^state: .* copies state 5/);
    expect(facts([[{ from: 0, map: [1, 0, 0, 1, 0, 0] }]])).toMatch(/^no-attractor/);
    expect(facts(new Array(1025).fill([half(0, 0, 0)]))).toMatch(/^too-many-states/);
    expect(facts([new Array(1e6).fill(0)])).toMatch(/^too-many-maps: State 1/);
    expect(facts([[half(-1, 0, 0)]])).toMatch(/^bad-input/);
    expect(facts("none")).toMatch(/^bad-input/);
    expect(refused(() => directed.directedFacts(undefined as unknown as System))).toMatch(/^bad-input/);
  });
});
