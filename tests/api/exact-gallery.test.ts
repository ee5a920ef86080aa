import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import "../../www/src/geometry/maps/exact-gallery";
import init, * as exact from "../../www/pkg/frond-exact.js";
import * as frond from "../../www/pkg/index.js";
import { exactOf } from "../../www/src/geometry/maps/exact";
import { load } from "./frond";

/** What the first picture draws: entries with few decimals mean these, and no formula. */
const isDecimal = (x: number) => Number(x.toFixed(4)) === x;

describe("exact numbers of the gallery", () => {
  beforeAll(async () => {
    const file = new URL("../../www/pkg/frond-exact_bg.wasm", import.meta.url);
    await Promise.all([load(), init({ module_or_path: readFile(file) })]);
  });

  it("are all: every entry is a formula's double, or a short decimal", () => {
    for (const preset of frond.presets()) {
      const formulas = exactOf({ ...preset, preset: preset.id });
      const values = exact
        .readNumbers([...formulas])
        .map((one) => ("value" in one ? Math.abs(one.value) : one));
      const entries = preset.maps.flat().map(Math.abs);
      expect(new Set(entries.filter((x) => !isDecimal(x))), preset.id).toEqual(new Set(values));
    }
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
});
