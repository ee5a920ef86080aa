import { expect, it } from "vitest";
import type { Told } from "#format/verdict";
import type { BendRoom3, SpaceBend } from "#wasm/api";
import { type Bending, bentWords, isOneToOne, isPlain } from "./holds";

const told = (verdict: Told["verdict"]): Told =>
  ({ verdict, gap: { lower: 0, upper: 0.1 }, diameter: 1 }) as Told;

/** A lattice of two points along each side: those on top go up. */
const lifted = (by: number): SpaceBend["moves"] =>
  Array.from({ length: 8 }, (_, i) => [0, 0, i < 4 ? 0 : by]);
const bend: Bending = { sizes: [2, 2, 2], moves: lifted(0.5), kb: 0, ke: 4, delta: 0.5, spin: "none" };
const whole: BendRoom3 = { min: [0, 0, 0], max: [1, 1, 1], continuous: true, deepest: 9 };
const raw = { ...whole, continuous: false };

it("a continuous bend keeps a connected shape in one piece, and says why", () => {
  const words = bentWords(told("connected"), bend, whole);
  expect([words.tone, words.text]).toEqual(["whole", "In one piece"]);
  expect(words.why).toMatch(/continuous image of a connected/);
  expect(bentWords(told("connected"), { ...bend, kb: 4 }, raw).tone).toBe("whole");
});

it("what only looks whole is not said to be so, bent", () => {
  expect(bentWords(told("touching"), bend, whole).tone).toBe("close");
});

it("nothing is claimed of what the shuffle may tear, nor of what a fold may join", () => {
  for (const verdict of ["connected", "touching", "disconnected"] as const) {
    expect(bentWords(told(verdict), bend, raw)).toMatchObject({ tone: "unknown", text: "Not known" });
  }
  expect(bentWords(told("disconnected"), bend, whole).tone).toBe("unknown");
  expect(bentWords(told("disconnected"), { ...bend, moves: lifted(-1), delta: 0 }, raw).tone).toBe("unknown");
});

it("nothing is shuffled without roughness, and up to one letter after those that stay", () => {
  const plain = (change: Partial<Bending>, deepest = 9) => isPlain({ ...bend, ...change }, deepest);
  expect([plain({}), plain({ delta: 0 }), plain({ kb: 3 }), plain({ kb: 3.5 }), plain({ kb: 2.9 })]).toEqual([
    false,
    true,
    true,
    true,
    false,
  ]);
  expect(plain({ ke: 16 }, 1)).toBe(true);
  // Displacements that turn do so from the first letter on.
  const turned = { spin: "orthogonal" } as const;
  expect([3, 4].map((kb) => plain({ ...turned, kb }))).toEqual([false, true]);
  expect(plain({ ...turned, kb: 2.5, ke: 2.5 })).toBe(false);
  expect(plain({ ...turned, delta: 0 })).toBe(true);
});

it("a bend that takes no two points to one leaves apart what was apart", () => {
  const apart = bentWords(told("disconnected"), { ...bend, delta: 0 }, raw);
  expect([apart.tone, apart.text]).toEqual(["broken", "In pieces"]);
  expect([0.9, 1, -0.9, -1].map((by) => isOneToOne({ ...bend, moves: lifted(by) }, raw))).toEqual([
    true,
    false,
    true,
    false,
  ]);
  // Moves are counted in longest sides: in a low box the top comes down sooner.
  expect(isOneToOne({ ...bend, moves: lifted(-0.5) }, { min: [0, 0, 0], max: [1, 1, 0.4] })).toBe(false);
  const middle: SpaceBend["moves"] = Array.from({ length: 12 }, (_, i) => [i % 3 === 1 ? 0.6 : 0, 0, 0]);
  expect(isOneToOne({ ...bend, sizes: [3, 2, 2], moves: middle }, whole)).toBe(false);
});

it("what is moved all alike is the shape as it was made", () => {
  const alike = { ...bend, moves: lifted(0).map(() => [0.3, 0, 1]) as SpaceBend["moves"] };
  expect(bentWords(told("disconnected"), alike, raw).tone).toBe("broken");
  expect(bentWords(told("connected"), { ...alike, spin: "orthogonal" }, raw).tone).toBe("unknown");
});

it("at rest it is the shape as it was made", () => {
  const rest = { ...bend, moves: lifted(0) };
  expect(bentWords(told("disconnected"), rest, raw).tone).toBe("broken");
  expect(bentWords(told("connected"), rest, raw).text).toBe("In one piece, proved");
});

it("while nothing is known nothing is said", () => {
  expect(bentWords(null, bend, whole).text).toBe("Checking …");
});
