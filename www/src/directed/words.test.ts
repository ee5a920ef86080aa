import { expect, it } from "vitest";
import type { DirectedCertificate, DirectedIfs } from "#wasm/api";
import { sizeWords, stateWords, wayWords } from "./words";

it("tells how much a shape is made of", () => {
  const map = { from: 0, map: [0.5, 0, 0, 0.5, 0, 0] } as DirectedIfs["states"][0][0];
  expect(sizeWords({ states: [[map]] })).toBe("1 map");
  expect(sizeWords({ states: [[map, map], [map]] })).toBe("2 states, 3 maps");
  expect([stateWords({ states: [[map]] }), stateWords({ states: [[map], [map]] })]).toEqual([
    "1 state",
    "2 states",
  ]);
});

it("says of a way what is known by now, and that the search has ended", () => {
  const proof = (state: DirectedCertificate["states"][0]): DirectedCertificate => ({
    states: [state],
    assuming: [],
    moments: 3,
  });
  const open = proof({ kind: "open", at: 0.03 });
  const say = (proof: DirectedCertificate | null, apart: number | null = null, ended = proof !== null) =>
    wayWords({ proof, apart, ended });
  expect(say(null)).toMatch(/^Searching for a proof/);
  expect(say(null, null, true)).toMatch(/found no proof/);
  // A moment in pieces is told at once, whatever is still looked for.
  for (const now of [say(null, 0.5), say(open, 0.5)])
    expect(now).toMatch(/at 50% it is in pieces, by Frond’s own bounds/);
  expect(say(open)).toMatch(/fails at 3%/);
  expect(say(proof({ kind: "connected" }))).toMatch(/in one piece at every moment of the path, proved:/);
  // Gaps that are finer than what was asked about do not make it false.
  expect(say(proof({ kind: "within", gap: 0.01 }), 0.5)).toMatch(/at most 1\/100/);
});
