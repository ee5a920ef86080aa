import { expect, it } from "vitest";
import type { DirectedIfs } from "#wasm/api";
import { sizeWords, stateWords } from "./words";

it("tells how much a shape is made of", () => {
  const map = { from: 0, map: [0.5, 0, 0, 0.5, 0, 0] } as DirectedIfs["states"][0][0];
  expect(sizeWords({ states: [[map]] })).toBe("1 map");
  expect(sizeWords({ states: [[map, map], [map]] })).toBe("2 states, 3 maps");
  expect([stateWords({ states: [[map]] }), stateWords({ states: [[map], [map]] })]).toEqual([
    "1 state",
    "2 states",
  ]);
});
