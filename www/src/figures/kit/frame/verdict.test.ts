import { expect, it } from "vitest";
import { reasonWords } from "#format/reason";

it("explains an address once, and leaves other reasons alone", () => {
  expect(reasonWords("The area says so.")).toBe("The area says so.");
  expect(reasonWords("The pieces meet in one point, whose addresses are 1(2) and 2(1).")).toBe(
    "The pieces meet in one point, whose addresses are 1(2) and 2(1). (1(2) means: piece 1, in it part 2, in that part 2 again, and so on.)",
  );
});
