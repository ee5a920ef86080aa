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
      "1.2 times as accurate as the next best (polyline, best corners).",
    );
    expect(nearestWords(0.067, list)).toBe("About as accurate as the next best (polyline, best corners).");
    expect(nearestWords(0.102, list)).toBe(
      "Here another method is more accurate: polyline, best corners, 0.0670%.",
    );
  }
  expect(nearestWords(0.1, [])).toBe("");
});

test("errors that are rounding have no ratio", () => {
  const line = (rms: number) => [{ name: "Polyline", rms }];
  expect(nearestWords(0, line(0))).toBe("Exact, like the next best method (polyline).");
  expect(nearestWords(4e-15, line(1e-15))).toBe("Exact, like the next best method (polyline).");
  expect(nearestWords(0, line(0.123))).toBe("Exact. The next best method (polyline) is off by 0.123%.");
  expect(nearestWords(0.123, line(0))).toBe("Here another method is more accurate: polyline, 0.0000%.");
});
