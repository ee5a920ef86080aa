import { expect, it } from "vitest";
import type { DirectedIfs } from "#wasm/api";
import { SYSTEM } from "./address";

it("are read back from an address as they were written, and nothing else is", () => {
  const system: DirectedIfs = {
    states: [[{ from: 1, map: [0.5, 0, 0, -0.5, 0.25, 0] }], [{ from: 0, map: [0.3, -0.1, 0.1, 0.3, 0, 1] }]],
  };
  expect(SYSTEM.read(SYSTEM.write(system))).toEqual(system);
  expect(SYSTEM.write(null)).toBe("");
  for (const wrong of ["", "0,1", "1,0,0,0,0,0,0", "0.5,0,0,0,0,0,0", "-1,0,0,0,0,0,0", ":", "0,0,0,0,0,0,x"])
    expect(SYSTEM.read(wrong), wrong).toBeNull();
  const large = { states: [Array.from({ length: 64 }, () => ({ from: 0, map: Array(6).fill(0.123456) }))] };
  expect(SYSTEM.write(large as unknown as DirectedIfs)).toBe("");
});
