import { expect, test } from "vitest";
import { nearestWords, percent } from "./nearness";

test("errors have digits that say something, and none lies", () => {
  expect([percent(0.0412), percent(0.204), percent(12.345), percent(Number.NaN)]).toEqual([
    "0.0412%",
    "0.204%",
    "12.35%",
    "–",
  ]);
});

test("the nearest of the others is named, in whatever order they come", () => {
  const others = [
    { name: "Polyline, split", rms: 0.102 },
    { name: "Polyline, best corners", rms: 0.067 },
    { name: "The paper’s fit", rms: 0.31 },
  ];
  for (const list of [others, [...others].reverse()]) {
    expect(nearestWords(0.058, list)).toBe(
      "1.2 times as near as the best of the others, polyline, best corners.",
    );
    expect(nearestWords(0.067, list)).toBe(
      "About as near as the best of the others, polyline, best corners.",
    );
    expect(nearestWords(0.102, list)).toBe("Here polyline, best corners is nearer: 0.0670%.");
  }
  expect(nearestWords(0.1, [])).toBe("");
});

test("errors that are rounding have no ratio", () => {
  const line = (rms: number) => [{ name: "Polyline", rms }];
  expect(nearestWords(0, line(0))).toBe("Exact, as is the best of the others, polyline.");
  expect(nearestWords(4e-15, line(1e-15))).toBe("Exact, as is the best of the others, polyline.");
  expect(nearestWords(0, line(0.123))).toBe("Exact; the best of the others, polyline, is 0.123% off.");
  expect(nearestWords(0.123, line(0))).toBe("Here polyline is nearer: 0.0000%.");
});
