import { expect, it } from "vitest";
import { painters } from "./crew";

it("has as many hands as there are cores and room", () => {
  expect(painters(854 * 480 * 4, 8)).toBe(7);
  expect(painters(854 * 480 * 4, 64)).toBe(8);
  expect(painters(854 * 480 * 4, 1)).toBe(1);
  expect(painters(3840 * 2160 * 4, 8)).toBe(1);
  expect(painters(1920 * 1080 * 4, 16)).toBe(6);
});
