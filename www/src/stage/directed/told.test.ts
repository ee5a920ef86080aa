import { expect, it } from "vitest";
import type { Told } from "#format/verdict";
import type { DirectedCertificate } from "#wasm/api";
import type { Way } from "#workers/directed/moment";
import { toldOf } from "./told";

const way: Way = { from: { states: [] }, to: { states: [] }, mode: "linear" };
const touching: Told = { verdict: "touching", gap: { lower: 0, upper: 0.001 }, diameter: 1 };
const proof: DirectedCertificate = {
  states: [{ kind: "connected" }, { kind: "connected" }, { kind: "within", gap: 0.01 }],
  assuming: [],
  moments: 0,
};
const told = (t: number, given: DirectedCertificate | null, at: Way = way) =>
  toldOf([touching, touching, touching], { ...at, t }, way, given).map(({ verdict }) => verdict);

it("says more of a moment only where all of its own way is proved as it is", () => {
  expect(told(0.5, proof)).toEqual(["connected", "connected", "touching"]);
  // At the ends the second state may be another one.
  for (const t of [0, 1]) expect(told(t, proof)).toEqual(["connected", "touching", "touching"]);
  const plain = ["touching", "touching", "touching"];
  expect(told(0.5, null)).toEqual(plain);
  expect(told(0.5, { ...proof, assuming: ["0.333 is 1/3"] })).toEqual(plain);
  expect(told(0.5, proof, { ...way, mode: "polar" })).toEqual(plain);
  expect(told(0.5, proof, { ...way, to: { states: [] } })).toEqual(plain);
});
