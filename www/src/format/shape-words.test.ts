import { expect, it } from "vitest";
import { type Described, shapeWords } from "./shape-words";

const gasket: Described = {
  name: "Gasket",
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0.25, 0.433],
  ],
  box: { x0: 0, y0: 0, x1: 1, y1: 0.866 },
  symmetries: { turns: 3, mirrors: [30, 90, 150] },
  answer: {
    verdict: "connected",
    overlaps: [
      [0, 1],
      [0, 2],
      [1, 2],
    ],
  },
  looks: { parts: 1, holes: 40 },
};

it("says what a shape looks like", () => {
  expect(shapeWords(gasket)).toBe(
    "Gasket: 3 copies, each 0.5 times as large, 1.0 wide and 0.87 high. It has the symmetries of an equilateral " +
      "triangle. It is in one piece. Copies that touch or overlap: 1 and 2; 1 and 3; 2 and 3. " +
      "A small picture shows 40 holes.",
  );
});

it("says no more than is known", () => {
  const words = (change: Partial<Described>) => shapeWords({ ...gasket, ...change });
  expect(words({ answer: null, looks: null })).not.toMatch(/piece|hole/);
  expect(words({ answer: { verdict: "touching", overlaps: [[0, 1]] } })).toContain("No gap is visible.");
  expect(words({ answer: { verdict: "touching", overlaps: [] } })).not.toContain("one piece");
  const many = { verdict: "disconnected" as const, overlaps: [] };
  expect(words({ answer: many, looks: { parts: 60, holes: 0 } })).toContain("more than 50 parts");
  expect(words({ answer: many, looks: { parts: 1, holes: 1 } })).toContain(
    "It is in pieces. A small picture",
  );
  expect(words({ symmetries: { turns: 2, mirrors: [0, 90] } })).toContain(
    "It is its own mirror image across a horizontal line and a vertical line and looks the same upside down.",
  );
  // Turned it is the same, and in no mirror: no square.
  expect(words({ symmetries: { turns: 4, mirrors: [] } })).toContain(
    "It looks the same when rotated by 90°.",
  );
  expect(words({ symmetries: { turns: 1, mirrors: [] } })).not.toContain("It has");
  expect(words({ box: { x0: 1, y0: 1, x1: 1, y1: 1 } })).toContain("a single point");
  expect(words({ box: { x0: 0, y0: 0, x1: 2, y1: 0 } })).toContain("on a horizontal line 2.0 long");
});
