import { expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { chosen, lean, leaning } from "./maps";

const FERN: MapRow[] = [
  [0, 0, 0, 0.16, 0, 0],
  [0.85, 0.04, -0.04, 0.85, 0, 1.6],
  [0.2, -0.26, 0.23, 0.22, 0, 1.6],
  [-0.15, 0.28, 0.26, 0.24, 0, 0.44],
];

it("leaves out what is switched off, and a map keeps its colour", () => {
  expect(chosen(FERN, [true, false, true, true])).toEqual({
    maps: [FERN[0], FERN[2], FERN[3]],
    hues: [0, 2, 3],
  });
});

it("turns the large map alone, and gives the fern back at its own turn", () => {
  const straight = leaning(FERN, 0);
  expect(straight[1]?.slice(0, 4)).toEqual([Math.hypot(0.85, 0.04), 0, -0, Math.hypot(0.85, 0.04)]);
  expect(straight.filter((_, i) => i !== 1)).toEqual(FERN.filter((_, i) => i !== 1));
  expect(lean(FERN)).toBeCloseTo(2.694, 3);
  const same = leaning(FERN, lean(FERN));
  for (const [i, x] of (same[1] ?? []).entries()) expect(x).toBeCloseTo(FERN[1]?.[i] ?? Number.NaN, 12);
});
