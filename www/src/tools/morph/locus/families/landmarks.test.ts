import { expect, test } from "vitest";
import type { Uv } from "#geometry/path";
import { landmarksOf } from "./landmarks";

/** A polynomial at s, by its coefficients from the lowest power on. */
function at(coefficients: readonly number[], [x, y]: Uv): number {
  let [re, im] = [0, 0];
  for (const a of coefficients.toReversed()) [re, im] = [re * x - im * y + a, re * y + im * x];
  return Math.hypot(re, im);
}

/** The coefficients of "1 − 2s + 2s³", as a note writes them. */
function read(text: string): number[] {
  const list: number[] = [];
  for (const [, sign, digits = "", s, power = ""] of text.matchAll(/([+−]?)\s*(\d*)(s?)([²³⁴⁵⁶⁷⁸⁹]?)/g)) {
    if (!digits && !s) continue;
    const n = !s ? 0 : power ? "²³⁴⁵⁶⁷⁸⁹".indexOf(power) + 2 : 1;
    list[n] = (sign === "−" ? -1 : 1) * Number(digits || 1);
  }
  return Array.from(list, (a) => a ?? 0);
}

test("the numbers of landmarks are those that they are shown at", () => {
  let [digits, roots] = [0, 0];
  for (const { name, about, s } of landmarksOf(2, 0.5)) {
    const written = /^s [=≈] (\d\.\d+) \+ (\d\.\d+) i/.exec(about);
    if (written) {
      digits++;
      for (const k of [0, 1] as const) {
        const text = written[k + 1] ?? "";
        expect(s[k].toFixed(text.length - 2), name).toBe(text.padEnd(text.length, "0"));
      }
    }
    const [, equation] = /where (.+?) = 0/.exec(about) ?? [];
    if (!equation) continue;
    roots++;
    expect(at(read(equation), s), name).toBeLessThan(1e-12);
  }
  expect([digits, roots]).toEqual([4, 3]);
  expect(read("1 − 2s + 2s² − 2s⁵ + 2s⁸")).toEqual([1, -2, 2, 0, 0, -2, 0, 0, 2]);
});
