import { expect, it, vi } from "vitest";
import { doubles } from "#geometry/maps/exact";
import { formulaAt, learnFormulas, readExact } from "./exact";

const ROOT = 0.6180339887498949;
/** What the module for exact numbers answers. */
const NUMBERS: Record<string, { value: number; text: string } | { problem: string }> = {
  "1/3": { value: 1 / 3, text: "1/3" },
  "-2/6": { value: -1 / 3, text: "-1/3" },
  "(1-sqrt5)/2": { value: -ROOT, text: "(1-√5)/2" },
  "2^0.5": { value: Math.SQRT2, text: "√2" },
  "cos(40deg)": { value: 0.766044443118978, text: "cos(40deg)" },
  e: { problem: "not a formula" },
};
vi.mock("#wasm/exact", () => ({
  loadExact: async () => ({ readNumbers: (list: string[]) => list.map((one) => NUMBERS[one]) }),
}));

it("reads formulas in the words of links, without a minus before all of one", async () => {
  expect(await readExact(["1/3", "-2/6", "(1-sqrt5)/2", "2^0.5", "e"])).toEqual([
    { value: 1 / 3, formula: "1/3" },
    { value: -1 / 3, formula: "1/3" },
    { value: -ROOT, formula: "(1-sqrt(5))/2" },
    { value: Math.SQRT2, formula: "sqrt(2)" },
    null,
  ]);
  expect(doubles.get("1/3")).toBe(1 / 3);
});

it("finds the formula of an entry, with a minus where it means the opposite", async () => {
  await readExact(["(1-sqrt5)/2"]);
  await learnFormulas(["1/3", "cos(40deg)"]);
  const formulas = ["1/3", "(1-sqrt(5))/2", "cos(40deg)", "unknown"];
  expect(formulaAt(1 / 3, formulas)).toBe("1/3");
  expect(formulaAt(-1 / 3, formulas)).toBe("-1/3");
  expect(formulaAt(-ROOT, formulas)).toBe("(1-sqrt(5))/2");
  expect(formulaAt(ROOT, formulas)).toBe("-(1-sqrt(5))/2");
  expect(formulaAt(-0.766044443118978, formulas)).toBe("-cos(40deg)");
  expect(formulaAt(0.3333333333333334, formulas)).toBeUndefined();
});
