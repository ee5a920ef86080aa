import { expect, test } from "vitest";
import { fileName, leftOut } from "./files";

test("what is left out of a file is counted", () => {
  expect(leftOut(13)).toMatch(/^13 systems of the plane are left out/);
  expect(leftOut(1)).toMatch(/^One system of the plane is left out/);
  expect(leftOut(0)).toBe("");
});

test("a file is named after its shape", () => {
  expect(fileName("Menger sponge")).toBe("frond-menger-sponge.ifs");
  expect(fileName("  ../Été  ")).toBe("frond-t.ifs");
  expect(fileName("木")).toBe("frond-shape.ifs");
});
