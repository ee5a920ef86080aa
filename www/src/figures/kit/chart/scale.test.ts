import { describe, expect, it } from "vitest";
import { along, linePath } from "./scale";

const linear = { min: 0, max: 4, ticks: [] };
const log = { min: 1, max: 100, log: true, ticks: [] };

describe("along", () => {
  it("runs from 0 to 1, by the value or by its logarithm", () => {
    expect(along(linear, 1)).toBe(0.25);
    expect(along(linear, 8)).toBe(2);
    expect(along(log, 10)).toBeCloseTo(0.5, 12);
    expect(along(log, 0)).toBe(Number.NEGATIVE_INFINITY);
  });
});

describe("linePath", () => {
  const size = { width: 100, height: 10 };
  it("puts the largest on top", () => {
    expect(
      linePath(
        [
          [0, 0],
          [4, 4],
        ],
        linear,
        linear,
        size,
      ),
    ).toBe("M0.0 10.0L100.0 0.0");
  });
  it("breaks where a logarithm has no place", () => {
    const path = linePath(
      [
        [1, 1],
        [2, 0],
        [3, 10],
        [4, 100],
      ],
      linear,
      log,
      size,
    );
    expect(path).toBe("M25.0 10.0M75.0 5.0L100.0 0.0");
  });
});
