import { expect, it } from "vitest";
import { nextKey } from "./commands";

it("goes round where it loops, and stays at the end where it does not", () => {
  const moments = [0, 0.25, 0.75];
  expect(nextKey(moments, 0.25, 1, true)).toBe(0.75);
  expect(nextKey(moments, 0.3, -1, true)).toBe(0.25);
  expect(nextKey(moments, 0.75, 1, true)).toBe(0);
  expect(nextKey(moments, 0.8, 1, false)).toBe(0.8);
  expect(nextKey(moments, 0, -1, true)).toBe(0.75);
  expect(nextKey([], 0.4, 1, true)).toBe(0.4);
});
