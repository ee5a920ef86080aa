/** What lessons say of their shapes, against what decides it. */
import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import initCore from "../../www/pkg/frond.js";
import initProof, { connectedness } from "../../www/pkg/frond-proof.js";
import { mapsOf } from "../../www/src/figures/kit/locus/set-m";
import { mapsAt } from "../../www/src/figures/kit/maps/morphs";
import * as map from "../../www/src/figures/lessons/lesson-20/map";
import { APART_S } from "../../www/src/figures/lessons/lesson-21/curves";
import * as bend from "../../www/src/figures/lessons/lesson-22/answer";
import type { Connectedness } from "../../www/src/wasm/api";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

beforeAll(async () => {
  await initCore({ module_or_path: read("frond_bg.wasm") });
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
    expect(isNarrow(at(0.17, LINE.v))).toBe(true);
    expect(isNarrow(at(0.5, 0.5))).toBe(false);
    const border = (u0: number, u1: number) => isBorder([u0, u1], [at(u0, LINE.v), at(u1, LINE.v)]);
    expect(border(0.165, 0.167)).toBe(true);
    expect(border(0.167, 0.165)).toBe(true);
    expect(border(0.16, 0.167)).toBe(false);
    expect(border(0.167, 0.168)).toBe(false);
    expect(border(LINE.u0, LINE.u1)).toBe(false);
  });

  it("takes no likely answer for a proved one", () => {
    const likely: Connectedness = { ...at(0, 0.5), verdict: "touching" };
    expect(isBorder([0.165, 0.166], [likely, at(0.166, LINE.v)])).toBe(false);
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
