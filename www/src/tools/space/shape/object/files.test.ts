import { expect, test } from "vitest";
import { leftOut } from "./files";

test("what is left out of a file is counted", () => {
  expect(leftOut(13)).toMatch(/^13 systems of the plane are left out/);
  expect(leftOut(1)).toMatch(/^One system of the plane is left out/);
  expect(leftOut(0)).toBe("");
});
