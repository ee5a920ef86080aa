/** Exact numbers, as others call them: formulas, proofs about what they mean, and what neighbours tell. */
import { readFile } from "node:fs/promises";
import { beforeAll, expect, it } from "vitest";
import init, { analyze, proveExact, readNumbers } from "../../www/pkg/frond-exact.js";
import { checkCertificate, type Ifs } from "../../www/pkg/index.js";
import { load, refused, wrong } from "./frond";

beforeAll(async () => {
  await load();
  await init({ module_or_path: readFile(new URL("../../www/pkg/frond-exact_bg.wasm", import.meta.url)) });
});

const thirds = (...shifts: number[]): Ifs => ({
  maps: shifts.map((e) => [1 / 3, 0, 0, 1 / 3, e, 0]),
});

it("reads formulas one by one", () => {
  expect(readNumbers(["2/6", "-cos(30°)", "phi", "cos 40°", "1/0", "i", "1 +"])).toEqual([
    { value: 1 / 3, text: "1/3" },
    { value: -Math.sqrt(3) / 2, text: "-√3/2" },
    { value: (1 + Math.sqrt(5)) / 2, text: "(1+√5)/2" },
    { value: expect.closeTo(Math.cos((40 * Math.PI) / 180), 15), text: "cos 40°" },
    { problem: expect.stringMatching(/division by zero/) },
    { problem: expect.stringMatching(/not real/) },
    { problem: expect.stringMatching(/not a formula/) },
  ]);
  expect(refused(() => readNumbers(Array(65).fill("1/2")))).toBe("bad-input");
  expect(refused(() => readNumbers(wrong([1])))).toBe("bad-input");
});

it("proves what is typed, and another program agrees", () => {
  const segment = proveExact(thirds(0, 1 / 3, 2 / 3), ["1/3", "2/3"]);
  const dust = proveExact(thirds(0, 2 / 3), ["1/3", "2/3"]);
  expect([segment.state, dust.state]).toEqual(["connected", "disconnected"]);
  for (const proof of [segment, dust]) {
    if (proof.state === "undecided") throw new Error(proof.why);
    const { certificate } = proof;
    expect(checkCertificate(certificate)).toMatchObject({ valid: true });
    // The same about the doubles is no proof, where points have to be shared.
    const { exact: _, ...doubles } = certificate;
    expect(checkCertificate(doubles).valid).toBe(proof === dust);
  }
  // The thirds of doubles are none.
  expect(proveExact(thirds(0, 1 / 3, 2 / 3), []).state).not.toBe("connected");
  expect(proveExact({ maps: [[2, 0, 0, 2, 0, 0]] }, []).state).toBe("undecided");
  expect(refused(() => proveExact(thirds(0), ["1/3", "0.3333333333333333"]))).toBe("exact-same-double");
});

it("tells dimension, open sets and overlaps", () => {
  const cross: Ifs = {
    maps: [
      [0, 0],
      [2 / 3, 0],
      [1 / 3, 1 / 3],
      [0, 2 / 3],
      [2 / 3, 2 / 3],
    ].map(([e = 0, f = 0]) => [1 / 3, 0, 0, 1 / 3, e, f]),
  };
  const vicsek = analyze(cross, ["1/3", "2/3"]);
  expect(vicsek).toMatchObject({
    openSetCondition: "yes",
    neighbours: 4,
    innerPoints: false,
    boundary: null,
  });
  expect(vicsek.dimension).toMatchObject({
    value: expect.closeTo(Math.log(5) / Math.log(3), 12),
    proved: true,
    exact: "log 5 / log 3",
  });
  // 0/3 + 3/9 = 1/3: words of two letters give one piece.
  const overlapping = analyze(thirds(0, 1, 3), ["1/3"]);
  expect(overlapping.openSetCondition).toBe("no");
  const words = overlapping.reasons.find(({ kind }) => kind === "exact-overlap")?.words ?? [];
  expect([...words].sort()).toEqual([
    [0, 2],
    [1, 0],
  ]);
  const doubles = analyze(thirds(0, 1 / 3, 2 / 3), [], { budget: 50 });
  expect([doubles.openSetCondition, doubles.neighbours]).toEqual(["undecided", null]);
  expect(refused(() => analyze(cross, [], { budget: 0 }))).toBe("bad-input");
  expect(refused(() => analyze(cross, ["√"]))).toBe("exact-not-formula");
});
