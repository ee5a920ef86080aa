import { expect, it } from "vitest";
import { problem, turned } from "./codes";

it("turns letters round, and is undone by doing it again", () => {
  expect(turned("1132", 0)).toBe("2311");
  expect(turned("1132", 1)).toBe("1231");
  expect(turned("1132", 4)).toBe("1132");
  for (const kept of [0, 1, 2, 3]) expect(turned(turned("1132", kept), kept)).toBe("1132");
});

it("has a word for each way to be wrong", () => {
  expect(problem("1132", 0, "2311")).toBe("");
  expect(problem("1132", 1, "1231")).toBe("");
  expect(problem("1132", 1, "2311")).toMatch(/first letter/);
  expect(problem("1132", 0, "1132")).toMatch(/itself/);
  expect(problem("1132", 0, "23")).toMatch(/4 letters/);
  expect(problem("1132", 0, "2222")).toMatch(/same/);
  expect(problem("1132", 0, "3211")).toMatch(/from its end/);
});
