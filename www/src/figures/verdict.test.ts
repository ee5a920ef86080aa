import { expect, it } from "vitest";
import { reasonWords } from "../state/reason";
import { exactWords } from "./verdict";

it("explains an address once, and leaves other reasons alone", () => {
  expect(reasonWords("The area says so.")).toBe("The area says so.");
  expect(reasonWords("The pieces share a point: 1(2) and 2(1).")).toBe(
    "The pieces share a point: 1(2) and 2(1). (1(2) reads: in piece 1, in its part 2, in the part 2 of that, and so on for ever.)",
  );
});

it("never calls touching pieces one piece", () => {
  const answer = {
    verdict: "touching" as const,
    gap: { lower: 0, upper: 1e-7 },
    overlaps: [],
    components: [0, 0],
    count: 1,
    diameter: 1,
    nodes: 1,
  };
  expect(exactWords(answer)).toMatchObject({ tone: "close", text: "Touching" });
  expect(exactWords({ ...answer, verdict: "disconnected", gap: { lower: 0.1, upper: 0.1 } }).aside).toBe(
    "proved, with a gap of 0.10",
  );
  expect(exactWords(null).text).toBe("Looking …");
});
