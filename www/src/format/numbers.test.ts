import { describe, expect, it } from "vitest";
import { parseNumber } from "./formula";
import { addStep, digitsApart, fixed, formatNumber, keyStep, plainNumber, rangeProblem } from "./numbers";

describe("plainNumber", () => {
  it("reads digits just as formulas do, and nothing else", () => {
    for (const text of ["0.5", " -.5 ", "+2.", "−0,25", "1e-3", "40000", "007", "-0"]) {
      const read = parseNumber(text);
      expect(plainNumber(text), text).toBe(read.ok && read.value);
    }
    for (const text of [
      "",
      " ",
      ".",
      "-",
      "1/3",
      "50%",
      "40 000",
      "1,2,3",
      "0x10",
      "1e999",
      "NaN",
      "--1",
      "1e",
    ])
      expect(plainNumber(text), text).toBeNull();
  });
});

describe("formatNumber", () => {
  it("drops trailing zeros and keeps whole numbers whole", () => {
    expect(formatNumber(0.5)).toBe("0.5");
    expect(formatNumber(100)).toBe("100");
    expect(formatNumber(0)).toBe("0");
    expect(formatNumber(-0.25)).toBe("−0.25");
    expect(formatNumber(1 / 3)).toBe("0.3333");
  });
  it("shows the very small and the very large by exponent", () => {
    expect(formatNumber(1e-7)).toBe("1.00e−7");
    expect(formatNumber(2.5e9)).toBe("2.50e9");
  });
  it("is read back as typed numbers are", () => {
    for (const x of [0.5, -0.25, 1e-7, 2.5e9, 12.3456, -3]) {
      const read = parseNumber(formatNumber(x));
      expect(read.ok && read.value).toBeCloseTo(x, 4);
    }
  });
});

describe("fixed", () => {
  it("has no minus zero", () => {
    expect(fixed(-0.001)).toBe("0.00");
    expect(fixed(-1)).toBe("−1.00");
  });
});

describe("addStep", () => {
  it("adds without the dust of binary fractions", () => {
    expect(addStep(0.1, 0.2)).toBe(0.3);
    expect(addStep(0.3, -0.1)).toBe(0.2);
    expect(addStep(0.001, -0.001)).toBe(0);
    expect(addStep(10, 0.01)).toBe(10.01);
  });
  it("keeps the digits of a value that has many", () => {
    expect(addStep(0.123456, 0.01)).toBe(0.133456);
  });
});

describe("keyStep", () => {
  const key = (name: string, shiftKey = false, altKey = false) =>
    keyStep({ key: name, shiftKey, altKey }, 0.01);
  it("goes finer with shift and coarser with alt", () => {
    expect(key("ArrowUp")).toBe(0.01);
    expect(key("ArrowLeft", true)).toBeCloseTo(-0.001, 12);
    expect(key("ArrowRight", false, true)).toBeCloseTo(0.1, 12);
    expect(key("PageDown")).toBeCloseTo(-0.1, 12);
    expect(key("a")).toBeNull();
  });
});

describe("rangeProblem", () => {
  it("holds both ends", () => {
    expect(rangeProblem(0, 0, 1)).toBeUndefined();
    expect(rangeProblem(1, 0, 1)).toBeUndefined();
    expect(rangeProblem(1.01, 0, 1)).toMatch(/most 1/);
    expect(rangeProblem(-0.01, 0, 1)).toMatch(/least 0/);
  });
});

it("shows as many digits as numbers need to be told apart", () => {
  expect(digitsApart([0.5, 0.5002], 4)).toBe(4);
  expect(digitsApart([0.5, 0.50002], 4)).toBe(5);
  expect(digitsApart([0.5, 0.5, 0.5], 4)).toBe(4);
  // What only rounding tells apart is not.
  expect(digitsApart([0.1 + 0.2, 0.3], 4)).toBe(4);
  expect(digitsApart([Number.NaN, 1.21, 1.24], 1)).toBe(2);
  expect(digitsApart([], 3)).toBe(3);
});
