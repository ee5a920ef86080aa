import { expect, it } from "vitest";
import { significant } from "./significant";

it("keeps as many digits whatever the size, and no computer's exponents", () => {
  expect(significant(12345.6)).toBe("12300");
  expect(significant(-0.0012345)).toBe("−0.00123");
  expect(significant(0.5)).toBe("0.5");
  expect(significant(999.9)).toBe("1000");
  expect(significant(999999)).toBe("1×10⁶");
  expect(significant(1.234e9)).toBe("1.23×10⁹");
  expect(significant(-2.5e-12, 2)).toBe("−2.5×10⁻¹²");
  expect(significant(0)).toBe("0");
  expect(significant(Number.NaN)).toBe("–");
});
