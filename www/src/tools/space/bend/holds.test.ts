import { expect, it } from "vitest";
import type { Told } from "#format/verdict";
import type { SpaceBend } from "#wasm/api";
import { bentWords } from "./holds";

const told = (verdict: Told["verdict"]): Told =>
  ({ verdict, gap: { lower: 0, upper: 0.1 }, diameter: 1 }) as Told;
const bend: Pick<SpaceBend, "kb" | "ke" | "moves"> = { kb: 0, ke: 4, moves: [[0, 0, 0.5]] };
const [whole, raw] = [{ continuous: true }, { continuous: false }];

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
});

it("at rest it is the shape as it was made", () => {
  const rest = { ...bend, moves: [[0, 0, 0]] as SpaceBend["moves"] };
  expect(bentWords(told("disconnected"), rest, raw).tone).toBe("broken");
  expect(bentWords(told("connected"), rest, raw).text).toBe("In one piece, proved");
});

it("while nothing is known nothing is said", () => {
  expect(bentWords(null, bend, whole).text).toBe("Looking …");
});
