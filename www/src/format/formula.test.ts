import { describe, expect, it } from "vitest";
import { formulaOf, parseNumber } from "./formula";

function value(text: string): number {
  const parsed = parseNumber(text);
  if (!parsed.ok) throw new Error(`${text}: ${parsed.message}`);
  return parsed.value;
}

describe("parseNumber", () => {
  it("reads decimals as people write them", () => {
    expect(value("0.5")).toBe(0.5);
    expect(value(" -.5 ")).toBe(-0.5);
    expect(value("+2.")).toBe(2);
    expect(value("−0,25")).toBe(-0.25);
    expect(value("1e-3")).toBe(0.001);
    expect(value("50%")).toBe(0.5);
  });
  it("reads fractions, roots and products", () => {
    expect(value("1/3")).toBe(1 / 3);
    expect(value("-√3/4")).toBeCloseTo(-Math.sqrt(3) / 4, 15);
    expect(value("sqrt(2)/2")).toBeCloseTo(Math.SQRT1_2, 15);
    expect(value("2 * pi / 3")).toBeCloseTo((2 * Math.PI) / 3, 15);
  });
  it("reads formulas as they are written on paper", () => {
    expect(value("(1+sqrt 5)/2")).toBeCloseTo(1.618033988749895, 15);
    expect(value("cos 30 deg")).toBeCloseTo(Math.sqrt(3) / 2, 15);
    expect(value("cos(30°)")).toBe(value("cos 30 deg"));
    expect(value("1/sqrt 2 - 1")).toBeCloseTo(Math.SQRT1_2 - 1, 15);
    expect(value("1+1")).toBe(2);
    expect(value("2√3/4")).toBeCloseTo(Math.sqrt(3) / 2, 15);
    expect(value("1/2√3")).toBeCloseTo(Math.sqrt(3) / 2, 15);
    expect(value("2(1 + 3)(2)")).toBe(16);
    expect(value("tan(pi/4) - atan 1")).toBeCloseTo(1 - Math.PI / 4, 15);
    expect(value("3 - 2 - 1")).toBe(0);
    expect(value("8/4/2")).toBe(1);
  });
  it("knows powers: of what stands before them, from the right", () => {
    expect(value("2^-1")).toBe(0.5);
    expect(value("-2^2")).toBe(-4);
    expect(value("2^3^2")).toBe(512);
    expect(value("√3²")).toBeCloseTo(3, 15);
    expect(value("3^(-1/2)")).toBeCloseTo(1 / Math.sqrt(3), 15);
  });
  it("takes thousands that are set apart", () => {
    expect(value("40 000")).toBe(40_000);
    expect(value("1,234.5")).toBe(1234.5);
    expect(value("-1.234.567,5")).toBe(-1_234_567.5);
  });
  it("takes the signs of other keyboards, e, logarithms and sizes", () => {
    expect(value("½")).toBe(0.5);
    expect(value("-3 ½")).toBe(-3.5);
    expect(value("2 ⅓ * 3")).toBeCloseTo(7, 15);
    expect(value("2**3 ÷ 4")).toBe(2);
    expect(value("1:4")).toBe(0.25);
    expect(value("2e")).toBe(2 * Math.E);
    expect(value("log2 8 - log10(100)")).toBe(1);
    expect(value("abs(1 - 3)")).toBe(2);
  });
  it("takes the unit of its field with the number, and degrees of an angle as they are", () => {
    const at = (text: string, unit: string) => {
      const parsed = parseNumber(text, unit);
      return parsed.ok ? parsed.value : parsed.message;
    };
    expect(at("30°", "°")).toBe(30);
    expect(at("360/7 deg", "°")).toBeCloseTo(360 / 7, 12);
    expect(at("90 cos 60°", "°")).toBeCloseTo(45, 12);
    expect(at("pi/6 rad", "°")).toBeCloseTo(30, 12);
    expect(at("-1/4 turn", "°")).toBeCloseTo(-90, 12);
    expect(at("1/4 turn", "")).toBeCloseTo(Math.PI / 2, 15);
    expect(at("2×", "×")).toBe(2);
    expect(at("50%", "%")).toBe(50);
  });
  it("asks of which base a logarithm is", () => {
    expect(parseNumber("log 4")).toEqual({ ok: false, message: expect.stringMatching(/base/) });
  });
  it("says which word it does not know", () => {
    const parsed = parseNumber("2 foo");
    expect(parsed.ok ? "" : parsed.message).toContain("foo");
  });
  it("never gives minus zero", () => {
    expect(Object.is(value("-0"), 0)).toBe(true);
  });
  it.each([
    "",
    "  ",
    "abc",
    "1..2",
    "1/",
    "/2",
    "--1",
    "1 2",
    "1 2 x",
    "NaN",
    "Infinity",
    "1,2,3",
    "0x10",
    "1+",
    "2^",
    "sin",
    "sqrt()",
    "(1",
    "1)",
    "()",
    "5%%",
    "constructor",
    "toString 1",
    "(".repeat(150),
    "1+".repeat(150),
    "%",
  ])("refuses %j with a hint", (text) => {
    const parsed = parseNumber(text);
    expect(parsed.ok).toBe(false);
    if (!parsed.ok) expect(parsed.message).toMatch(/number|bracket|without/);
  });
  it("refuses what is not finite", () => {
    expect(parseNumber("1/0").ok).toBe(false);
    expect(parseNumber("0/0").ok).toBe(false);
    expect(parseNumber("1e999").ok).toBe(false);
    expect(parseNumber("sqrt(-1)").ok).toBe(false);
    expect(parseNumber("ln 0").ok).toBe(false);
  });
});

describe("formulaOf", () => {
  it("writes what was typed in letters that a link keeps", () => {
    expect(formulaOf(" 1 / 3 ")).toBe("1/3");
    expect(formulaOf("2√3/4")).toBe("2sqrt3/4");
    expect(formulaOf("−COS 60°/3")).toBe("-cos60deg/3");
    expect(formulaOf("0,25")).toBe("0.25");
    expect(formulaOf("½ π²")).toBe("(1/2)pi**2");
    expect(formulaOf("33%")).toBe("(33)/100");
    expect(formulaOf("2^(1/3)")).toBe("2**(1/3)");
  });

  it("gives an angle in degrees", () => {
    expect(formulaOf("60°", "°")).toBe("60");
    expect(formulaOf("1/6 turn", "°")).toBe("(1/6)*360");
  });
});
