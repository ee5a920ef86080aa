import { expect, test } from "vitest";
import { plainName } from "./download";

test("a name has what every system of files takes, and is never empty", () => {
  expect(plainName("Menger sponge", "shape")).toBe("menger-sponge");
  expect(plainName("  ../Été  ", "shape")).toBe("été");
  expect(plainName("木", "shape")).toBe("木");
  expect(plainName("E\u0301te\u0301", "shape")).toBe("été");
  expect(plainName("…/*", "shape")).toBe("shape");
  expect(plainName("A very long name of a shape", "shape", 6)).toBe("a-very");
});
