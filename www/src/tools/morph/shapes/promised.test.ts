import { expect, it } from "vitest";
import { scene } from "#document/scene";
import { isPromised, kept, promise } from "./promised";

it("is about the pair that was chosen, as it came, and is kept once", () => {
  const now = scene.peek();
  const ends = { a: { ...now.a, preset: "fern" }, b: { ...now.b, preset: "tree" } };
  const auto = {
    ...now,
    ...ends,
    path: { kind: "auto" as const, points: [] },
    correspondence: [],
    turns: [],
  };
  expect(isPromised(auto)).toBe(false);
  promise(auto, false);
  expect(isPromised(auto)).toBe(false);
  promise(auto, true);
  expect(isPromised(auto)).toBe(true);
  // Whoever has changed anything is asked.
  const { preset: _, ...edited } = auto.a;
  for (const other of [
    { ...auto, a: edited },
    { ...auto, b: { ...auto.b, preset: "else" } },
    { ...auto, turns: [1, 0, 0] },
    { ...auto, path: { kind: "straight" as const, points: [] } },
  ])
    expect(isPromised(other)).toBe(false);
  kept();
  expect(isPromised(auto)).toBe(false);
});
