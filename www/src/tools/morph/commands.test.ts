import { expect, it, vi } from "vitest";

vi.mock("#wasm/core", () => ({ frond: {} }));
const { nextFrame } = await import("./commands");

it("goes to the next moment, or to the end", () => {
  expect(nextFrame([0, 0.5, 1], 0.5, 1)).toBe(1);
  expect(nextFrame([0, 0.5, 1], 0.4, -1)).toBe(0);
  expect(nextFrame([0, 0.5, 1], 1, 1)).toBe(1);
  expect(nextFrame([], 0.3, -1)).toBe(0);
});
