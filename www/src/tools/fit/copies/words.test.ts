import { expect, it } from "vitest";
import { copyWords, stepWords } from "./words";

const copy = { edge: 3, from: 0, span: 4, ratio: 0.314, across: 0.126, degrees: -14.2, mirrored: true };

it("says size, turn and mirror of a copy", () => {
  expect(copyWords(copy)).toBe(
    "This edge copies that arc of 4 edges: 0.31 times as long, 0.13 times as high, rotated 14° to the right, mirrored.",
  );
  expect(copyWords({ ...copy, degrees: 180, mirrored: false })).toContain("high, rotated by half a turn.");
  expect(copyWords({ ...copy, degrees: 0.2, mirrored: false })).toContain("0.13 times as high.");
  expect(copyWords({ ...copy, degrees: 90, mirrored: false })).toContain("90° to the left.");
});

it("says how far a curve has grown", () => {
  expect([null, 0, 1, 2.5].map(stepWords)).toEqual([
    "all of it",
    "the polygon of knots",
    "1 step",
    "2.5 steps",
  ]);
});
