import { describe, expect, it } from "vitest";
import { fraction, held, ranges, rescaled, SHIFT, shiftWords } from "./shift";

describe("a shift", () => {
  it("is written in lowest terms", () => {
    expect([fraction(2, 4), fraction(-6, 3), fraction(0, 7), fraction(-3, 9), fraction(7, 7)]).toEqual([
      "1/2",
      "−2",
      "0",
      "−1/3",
      "1",
    ]);
    expect(shiftWords([1, -2], 4, false)).toBe("(1/4, −1/2)");
    expect(shiftWords([1, 0], 4, true)).toBe("1/4");
  });

  it("goes as far as the shapes reach each other, ends with them", () => {
    const box = { x0: 0, y0: -1e-12, x1: 1, y1: 1e-12 };
    const found = ranges(box, box, 9);
    expect(found.map((range) => range.map((p) => p + 0))).toEqual([
      [-9, 9],
      [0, 0],
    ]);
    expect(ranges({ ...box, x1: 0.5 }, box, 3)[0]).toEqual([-3, 1]);
  });

  it("is held within, and comes near with other denominators", () => {
    const limits = [
      [-9, 9],
      [0, 0],
    ] as const;
    expect(held([20, -3, 9], limits)).toEqual([9, 0, 9]);
    expect(held([-2, 0, 9], limits)).toEqual([-2, 0, 9]);
    expect(rescaled([1, -1, 4], 9)).toEqual([2, -2, 9]);
    expect(rescaled([0, 1, 1000], 1)).toEqual([0, 0, 1]);
  });

  it("is read from an address only with a denominator", () => {
    expect(SHIFT.read("1,0,4")).toEqual([1, 0, 4]);
    for (const text of ["1,0,0", "1,0,-4", "1,0", "1,0,1001", "1.5,0,4", "30000,0,4"]) {
      expect(SHIFT.read(text), text).toBeNull();
    }
  });
});
