import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import "../../www/src/document/exact/gallery";
import init, * as exact from "../../www/pkg/frond-exact.js";
import * as frond from "../../www/pkg/index.js";
import { exactOf } from "../../www/src/geometry/maps/exact";
import { load, refused } from "./frond";

const third = 1 / 3;
/** A segment of three thirds. */
const thirds = {
  maps: [0, third, 2 / 3].map(
    (x) => [third, 0, 0, third, x, 0] as [number, number, number, number, number, number],
  ),
};
/** What the first picture draws: entries with few decimals mean these, and no formula. */
const isDecimal = (x: number) => Number(x.toFixed(4)) === x;

describe("exact numbers", () => {
  beforeAll(async () => {
    const file = new URL("../../www/pkg/frond-exact_bg.wasm", import.meta.url);
    await Promise.all([load(), init({ module_or_path: readFile(file) })]);
  });

  it("are read from formulas: the nearest double and a short text, or why not", () => {
    expect(exact.readNumbers(["1/3", "cos(60deg)/3", "2**(1/2)", "-sqrt(12)/4"])).toEqual([
      { value: third, text: "1/3" },
      { value: 1 / 6, text: "1/6" },
      { value: Math.SQRT2, text: "√2" },
      { value: -0.8660254037844386, text: "-√3/2" },
    ]);
    for (const wrong of ["1/0", "pi", "i", "1..2", "", "((", "9".repeat(201), "1e999"])
      expect(exact.readNumbers([wrong])).toEqual([{ problem: expect.stringMatching(/\w/) }]);
    expect(refused(() => exact.readNumbers(Array(65).fill("1")))).toBe("bad-input");
  });

  it("are those of the gallery: every entry is a formula's double, or a short decimal", () => {
    for (const preset of frond.presets()) {
      const formulas = exactOf({ ...preset, preset: preset.id });
      const values = exact
        .readNumbers([...formulas])
        .map((one) => ("value" in one ? Math.abs(one.value) : one));
      const entries = preset.maps.flat().map(Math.abs);
      expect(new Set(entries.filter((x) => !isDecimal(x))), preset.id).toEqual(new Set(values));
    }
  });

  it("are what is proved, and not what the doubles are", () => {
    const numbers = ["1/3", "2/3"];
    const proof = exact.proveExact(thirds, numbers);
    expect(proof.state).toBe("connected");
    if (proof.state !== "connected") return;
    expect(proof.certificate.exact?.entries.length).toBe(8);
    expect(frond.checkCertificate(proof.certificate).valid).toBe(true);
    const { exact: _, ...doubles } = proof.certificate;
    expect(frond.checkCertificate(doubles).valid).toBe(false);
    expect(exact.proveExact(thirds, []).state).not.toBe("connected");
    const [first, , last] = thirds.maps;
    const cantor = { maps: first && last ? [first, last] : [] };
    expect(exact.proveExact(cantor, numbers).state).toBe("disconnected");
  });

  it("tell the dimension of Koch's curve, and the boundary of the dragon", () => {
    const shape = (id: string) => {
      const preset = frond.presets().find((one) => one.id === id);
      if (!preset) throw new Error(id);
      return exact.analyze(preset, [...exactOf({ ...preset, preset: id })]);
    };
    expect(shape("koch")).toMatchObject({
      openSetCondition: "yes",
      dimension: { exact: "log 4 / log 3", proved: true },
      innerPoints: false,
      boundary: null,
    });
    const { boundary, innerPoints } = shape("dragon");
    expect(innerPoints).toBe(true);
    // Twice the logarithm of the largest root of x³ − x² − 2 in base 2 (Chang and Zhang 2000).
    expect(boundary?.dimension.value).toBeCloseTo(1.523627086202492, 12);
  });

  it("refuse what is no list, no number or too much", () => {
    expect(refused(() => exact.analyze(thirds, ["1/3", "oops"]))).toBe("exact-not-formula");
    expect(refused(() => exact.analyze(thirds, [], { budget: 0 }))).toBe("bad-input");
    expect(refused(() => exact.analyze({ maps: [[0, 0, 0, 0, 0, 0]] }, []))).toBe("exact-singular");
  });
});
