import { expect, test } from "vitest";
import { fileName } from "./files";

test("a file is named after its shape", () => {
  expect(fileName("Menger sponge")).toBe("frond-menger-sponge.ifs");
  expect(fileName("  ../Été  ")).toBe("frond-t.ifs");
  expect(fileName("木")).toBe("frond-shape.ifs");
});
