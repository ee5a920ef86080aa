import { expect, it } from "vitest";
import type { Scene } from "#wasm/api";
import { outdated } from "./results";
import { namesOf } from "./strip";

const frame = {
  t: 0.25,
  verdict: { verdict: "connected" as const, gap: { lower: 0, upper: 0 }, diameter: 1 },
  bitmap: {} as ImageBitmap,
  stale: false,
};

it("keeps a picture of the same shapes, as one of before, and none of others", () => {
  expect(outdated(frame, false)).toEqual({ t: 0.25, verdict: null, bitmap: frame.bitmap, stale: true });
  expect(outdated(frame, true)).toEqual({ t: 0.25, verdict: null, bitmap: null, stale: true });
  // Other colours change nothing of what is known.
  expect(outdated(frame, false, true)).toEqual({ ...frame, stale: true });
});

it("tells shapes apart by what stands at the two ends", () => {
  const scene = { a: { name: "Fern" }, b: { name: "Tree" } } as Scene;
  expect(namesOf(scene)).not.toBe(namesOf({ ...scene, b: { name: "Maple" } } as Scene));
  const curves = { a: { name: "Oak" }, b: { name: "Tree" } };
  expect(namesOf({ ...scene, curves } as unknown as Scene)).not.toBe(namesOf(scene));
});
