/** What lessons say of their shapes, against what decides it. */
import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import initCore from "../../www/pkg/frond-first.js";
import initProof, { checkPath, connectedness, planPath } from "../../www/pkg/frond-proof.js";
import { barnsley } from "../../www/src/figures/kit/connectedness/barnsley";
import { preset } from "../../www/src/figures/kit/frame/studio-link";
import { type Complex, mapsOf } from "../../www/src/figures/kit/locus/set-m";
import { mapsAt } from "../../www/src/figures/kit/maps/morphs";
import * as cells from "../../www/src/figures/lessons/lesson-3/cells";
import { sideOf } from "../../www/src/figures/lessons/lesson-7/sides";
import { isLargeDust, isSmallPiece } from "../../www/src/figures/lessons/lesson-8/found";
import { kept, PAIRINGS, TURNS } from "../../www/src/figures/lessons/lesson-10/pairings";
import * as map from "../../www/src/figures/lessons/lesson-20/map";
import { APART_S } from "../../www/src/figures/lessons/lesson-21/curves";
import * as bend from "../../www/src/figures/lessons/lesson-22/answer";
import * as walk from "../../www/src/figures/lessons/lesson-25/walk";
import type { Connectedness } from "../../www/src/wasm/api";
import { startBends } from "../../www/src/wasm/bend";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

beforeAll(async () => {
  await initCore({ module_or_path: read("frond-first_bg.wasm") });
  await startBends(read("frond-bend_bg.wasm").then((bytes) => WebAssembly.compile(bytes)));
  await initProof({ module_or_path: read("frond-proof_bg.wasm") });
});

describe("Reading a map", () => {
  const { ends, isBorder, isNarrow, LINE, MARKED, TRUTH } = map;
  const at = (u: number, v: number) => connectedness({ maps: mapsAt(ends(), [u, v]) }, { epsilon: 1e-6 });

  it("tells the truth of its three places", () => {
    for (const {
      name,
      at: [u, v],
    } of MARKED)
      expect(at(u, v).verdict, name).toBe(name === TRUTH ? "connected" : "disconnected");
    // "At 3 the pieces lie across each other."
    expect(at(0.5, 1.75).reason?.kind).toBe("crossings");
  });

  it("tells the truth of both ends", () => {
    expect(at(0, 0).verdict).toBe("connected");
    expect(at(1, 1).verdict).toBe("connected");
  });

  it("has exercises that can be solved as their hints say, and are not solved at the start", () => {
    expect(isNarrow(at(0.45, LINE.v))).toBe(true);
    expect(isNarrow(at(0.5, 0.5))).toBe(false);
    const border = (u0: number, u1: number) => isBorder([u0, u1], [at(u0, LINE.v), at(u1, LINE.v)]);
    expect(border(0.446, 0.447)).toBe(true);
    expect(border(0.447, 0.446)).toBe(true);
    expect(border(0.44, 0.447)).toBe(false);
    expect(border(0.447, 0.448)).toBe(false);
    expect(border(LINE.u0, LINE.u1)).toBe(false);
  });

  it("takes no likely answer for a proved one", () => {
    const likely: Connectedness = { ...at(0, 0.5), verdict: "touching" };
    expect(isBorder([0.446, 0.447], [likely, at(0.447, LINE.v)])).toBe(false);
    expect(isNarrow(likely)).toBe(false);
  });
});

describe("Every level, or only the whole", () => {
  const { apartFromPlain, DELTA, FAR, isQuietAndLively, NEAR, NEARLY_PLAIN, shares, WHOLE } = bend;

  it("is plain at roughness 0, and at locality 9", () => {
    for (const piece of [WHOLE, FAR, NEAR]) {
      expect(apartFromPlain(piece, 0, 0)).toBe(0);
      expect(apartFromPlain(piece, 9, DELTA)).toBe(0);
      expect(apartFromPlain(piece, 0, DELTA)).toBeGreaterThan(0.05);
    }
  });

  it("shares out the lift as the program does", () => {
    // Two turned letters for the third level: what is apart from plain at a small roughness is that share, or less.
    const [, , third = 0] = shares(0, 0.01);
    const apart = (delta: number) => apartFromPlain(WHOLE, 0, delta);
    expect(apart(0.01) / third).toBeCloseTo(apart(0.002) / (shares(0, 0.002)[2] ?? 0), 2);
  });

  it("has exercises that can be solved as their hints say, and are not solved at the start", () => {
    expect(apartFromPlain(WHOLE, 0, 0.25)).toBeLessThan(NEARLY_PLAIN);
    expect(apartFromPlain(WHOLE, 0, DELTA)).toBeGreaterThan(NEARLY_PLAIN);
    const both = (kb: number) =>
      isQuietAndLively(apartFromPlain(FAR, kb, DELTA), apartFromPlain(NEAR, kb, DELTA));
    expect([0, 2, 3, 4, 9].filter(both)).toEqual([3]);
  });
});

it("Two curves that must cross: the two pieces are apart, though no picture shows it", () => {
  const found = connectedness({ maps: mapsOf(APART_S) }, { epsilon: 1e-6 });
  expect(found.verdict).toBe("disconnected");
  expect(found.gap.upper / found.diameter).toBeLessThan(1 / 600);
});

describe("Dots and lines", () => {
  const judged = (chosen: number[]) => connectedness({ maps: cells.mapsOf(chosen) }, { epsilon: 1e-6 });

  it("finds stars, and no others", () => {
    const isStar = (chosen: number[]) => cells.isStar(chosen.length, judged(chosen).overlaps);
    expect(isStar([1, 3, 4, 5, 7])).toBe(true);
    expect(isStar([0, 2, 4, 6, 8])).toBe(true);
    expect(isStar([0, 1, 2])).toBe(false);
    expect(isStar([0, 1, 2, 4, 7])).toBe(false);
  });

  it("tells cells that share an edge from pieces that touch", () => {
    const isDeceiving = (chosen: number[]) => cells.isDeceiving(chosen, judged(chosen));
    expect(isDeceiving([0, 1])).toBe(true);
    expect(isDeceiving([1, 4])).toBe(true);
    expect(isDeceiving([0, 1, 2])).toBe(false);
    expect(isDeceiving([0, 2])).toBe(false);
  });
});

it("A bound that closes in: its exercises have the solutions that are given", () => {
  const steps = (r: number) => barnsley(r, 11).at(-1)?.n;
  expect([0.42, 0.45, 0.48, 0.49].map(steps)).toEqual([2, 2, 4, 5]);
  expect(2 * 0.48 ** 6).toBeLessThan(0.04);
  expect(2 * 0.48 ** 5).toBeGreaterThan(0.04);
});

it("Straight on, or led: there is a way on either side, and where the exercises begin there is none", () => {
  const [from, to] = [{ maps: preset("dragon-3").maps }, { maps: preset("terdragon").maps }];
  const holds = (u: number, v: number) =>
    checkPath(from, to, [[0, 0], [u, v], [1, 1]], { epsilon: 1 / 600, samples: 301 }).holds; // biome-ignore format: a path
  expect([holds(0.5, 0.1), sideOf([0.5, 0.1])]).toEqual([true, "turning first"]);
  expect([holds(0.2, 0.45), sideOf([0.2, 0.45])]).toEqual([true, "moving first"]);
  expect([holds(0.8, 0.3), holds(0.1, 0.9)]).toEqual([false, false]);
});

it("The set M: dust and one piece where the exercises say, and not where they begin", () => {
  const judged = (s: Complex) => connectedness({ maps: mapsOf(s) }, { epsilon: 1e-6 });
  const dust = (s: Complex) => isLargeDust(s, judged(s));
  expect([dust([0, 0.7]), dust([0, -0.7]), dust([0, 0.71]), dust([0.5, 0.5]), dust([0.4, 0.5])]).toEqual([
    true,
    true,
    false,
    false,
    false,
  ]);
  const piece = (s: Complex) => isSmallPiece(s, judged(s));
  expect([piece([0.5, 0]), piece([-0.5, 0]), piece([0.3, 0.4]), piece([0, 0.5]), piece([0.51, 0])]).toEqual([
    true,
    true,
    false,
    false,
    false,
  ]);
});

it("The wrong pairing: the six pairings of dragon and gasket", () => {
  const [from, to] = [{ maps: preset("dragon-3").maps }, { maps: preset("gasket").maps }];
  const plans = PAIRINGS.map((pairing) => ({
    pairing,
    ...planPath(from, to, { correspondence: [...pairing], turns: TURNS, epsilon: 1 / 600 }),
  }));
  const two = plans.filter(({ pairing }) => kept(pairing) === 1);
  expect(two.map(({ pairing, holds }) => [pairing.join(""), holds])).toEqual([
    ["102", false],
    ["021", true],
    ["210", true],
  ]);
  const round = plans.filter(({ pairing }) => kept(pairing) === 0);
  expect(round.map(({ pairing, gap }) => [pairing.join(""), gap < 0.01])).toEqual([
    ["120", true],
    ["201", false],
  ]);
});

describe("A walk along the edge of M", () => {
  const at = (degrees: number) =>
    connectedness({ maps: mapsOf(walk.onCircle(walk.ASKED, degrees)) }, { epsilon: 1e-6 }).verdict;

  it("changes three times, and all of it is proved", () => {
    const states = Array.from({ length: walk.TO - walk.FROM + 1 }, (_, i) => at(walk.FROM + i));
    expect(new Set(states)).toEqual(new Set(["connected", "disconnected"]));
    expect(walk.changes(states)).toBe(walk.CHANGES);
    const whole = states.flatMap((state, i) => (state === "connected" ? [walk.FROM + i] : []));
    expect(whole).toEqual([65, 66, 67, 68, 76, 77, 78, 79, 80, 81]);
  });

  it("closes at the root of one half, straight up", () => {
    const up = (size: number) => connectedness({ maps: mapsOf(walk.onCircle(size, 90)) }, { epsilon: 1e-6 });
    expect([707, 708].map((size) => up(size / 1000).verdict)).toEqual(["disconnected", "connected"]);
  });
});
