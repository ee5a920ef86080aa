import { expect, it } from "vitest";
import { keepTyped, typedAs } from "./typed";

it("keeps formulas by their field and value, and no plain digits", () => {
  keepTyped("Move up", Math.SQRT1_2, " 1/√2 ");
  expect(typedAs("Move up", Math.SQRT1_2)).toBe("1/√2");
  expect(typedAs("Move up", Math.SQRT1_2 * (1 + 1e-15))).toBe("1/√2");
  expect(typedAs("Move up", Math.SQRT1_2 + 1e-9)).toBeUndefined();
  expect(typedAs("Move across", Math.SQRT1_2)).toBeUndefined();
  for (const digits of ["0.5", "−0,5", "5e-1", "5e−1", "50%"]) {
    keepTyped("Move up", 0.5, digits);
    expect(typedAs("Move up", 0.5)).toBeUndefined();
  }
});

it("shows the latest way of writing a value", () => {
  keepTyped("a", 0.5, "1/2");
  keepTyped("a", 0.5, "2/4");
  expect(typedAs("a", 0.5)).toBe("2/4");
  keepTyped("a", 0.5, "0.5");
  expect(typedAs("a", 0.5)).toBeUndefined();
});

it("does not grow without bound", () => {
  for (let i = 2; i < 1000; i++) keepTyped("b", 1 / i, `1/${i}`);
  expect(typedAs("b", 1 / 2)).toBeUndefined();
  expect(typedAs("b", 1 / 999)).toBe("1/999");
});
