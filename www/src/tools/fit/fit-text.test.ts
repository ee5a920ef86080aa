import { expect, test } from "vitest";
import type { FitFigures } from "#workers/fit/curve";
import { compareBytes, compareWords, roughWords, signed } from "./fit-text";

const figures = (rms: number): FitFigures => ({
  rms,
  hausdorff: 0.4,
  lengthRatio: 0.9,
  outlineSlope: 1.2,
  fitSlope: 1.19,
});
const rival = (method: "squares" | "fourier", rms: number) => ({
  method,
  numbers: 260,
  points: new Float64Array(),
  figures: figures(rms),
});

test("the comparison names the best of the others, and is fair to it", () => {
  const all = [rival("fourier", 0.3), rival("squares", 0.12)];
  expect(compareWords(figures(0.1), all)).toBe(
    "1.2 times as accurate as the next best (polyline, best corners).",
  );
  expect(compareWords(figures(0.119), all)).toMatch(/^About as accurate/);
  expect(compareWords(figures(0.2), all)).toMatch(/more accurate: polyline, best corners, 0\.120%/);
  expect(compareWords(figures(0.2), [])).toBe("");
});

test("so is that of bytes", () => {
  const points = new Float64Array();
  const all = [
    { method: "bezier", rms: 0.2, points },
    { method: "squares", rms: 0.12, points },
  ] as const;
  expect(compareBytes(0.1, all)).toBe("1.2 times as accurate as the next best (polyline, best corners).");
  expect(compareBytes(0.12, all)).toMatch(/^About as accurate/);
  expect(compareBytes(0.2, all)).toMatch(/more accurate: .*0\.120%/);
});

test("figures have digits that say something, and none lies", () => {
  expect([signed(0.0123), signed(-0.0123), signed(0.0001)]).toEqual(["+0.012", "−0.012", "0.000"]);
  const rough = { ...figures(1), fitSlope: 1.195, lengthRatio: 1.01 };
  expect(roughWords(rough)).toBe("As rough as the outline.");
  // A tangle as long as two outlines is not praised for its dimension.
  expect(roughWords({ ...rough, lengthRatio: 2 })).toBe(
    "About as rough as the outline: it has 200% of its perimeter.",
  );
  expect(roughWords({ ...rough, fitSlope: 1.25, lengthRatio: 1.2 })).toMatch(
    /^Rougher .* 120% of its perimeter/,
  );
  expect(roughWords({ ...figures(1), fitSlope: 1.1 })).toMatch(/^Smoother .* 90% of its perimeter/);
});
