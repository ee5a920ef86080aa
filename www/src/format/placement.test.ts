import { expect, test } from "vitest";
import type { Place3 } from "#wasm/api";
import { axisWords, divergingWords, placeWords, unit } from "./placement";

const still: Place3 = { shift: [0, 0, 0], turn: [0, 0, 0, 1], scale: [1, 1, 1], exact: true, determinant: 1 };

test("what was done is told in the order in which it is done", () => {
  expect(placeWords(still)).toBe("nothing");
  expect(placeWords({ ...still, turn: [0, 0, Math.SQRT1_2, Math.SQRT1_2], shift: [1, 0, -2] })).toBe(
    "rotated by 90° about z, moved by (1, 0, −2)",
  );
  expect(placeWords({ ...still, scale: [2, 2, 2] })).toBe("scaled by 2");
  expect(placeWords({ ...still, scale: [2, 1, 1], exact: false })).toBe(
    "scaled by 2, 1, 1, and also sheared or mirrored",
  );
  // The same turn, told from the other side.
  expect(placeWords({ ...still, turn: [0, 0, -Math.SQRT1_2, -Math.SQRT1_2] })).toBe("rotated by 90° about z");
  expect(placeWords(null)).toBe("a change with no simple description");
});

test("directions by their axes", () => {
  expect(axisWords([0, 0, 1])).toBe("z");
  expect(axisWords([0, -1, 0])).toBe("−y");
  expect(axisWords([0.6, 0.8, 0])).toBe("(0.6, 0.8, 0)");
  expect(unit([0, 0, 0])).toBeNull();
  expect(unit([0, 3, 4])).toEqual([0, 0.6, 0.8]);
});

test("numbers that grow are named", () => {
  expect(divergingWords([])).toMatch(/^No number grows/);
  expect(divergingWords([[0, 1]])).toBe("1 number grows without bound, in the third column: row 2 of w₁.");
  expect(divergingWords([[0, 0, 1]])).toBe(
    "1 number grows without bound, in the second column: row 1 of w₁.",
  );
  expect(
    divergingWords([
      [0, 0, 1],
      [1, 2, 0],
    ]),
  ).toBe("2 numbers grow without bound: row 1, column 2 of w₁; row 3, column 1 of w₂.");
  expect(divergingWords(Array.from({ length: 8 }, (_, i) => [i, 0] as const))).toMatch(
    /^8 numbers .* row 1 of w₆ and 2 more\.$/,
  );
});
