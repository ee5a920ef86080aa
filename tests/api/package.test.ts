import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as frond from "../../www/pkg/index.js";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** What README.md promises of the package's first entry. */
const PROMISED = `presets validate attractor rasterize bounds connectedness certificate checkCertificate indexBuffer
  barnsleyTest pair interpolate locus LocusTiles planPath planPathIn checkPath certifyPath candidates rateCandidate routes
  familyMaps criticalScale FamilyTiles PathSearch conjugate polar encodeScene decodeScene defaultScene settleLocus settleFamily
  CurveMorph curvePresets curveFacts packCurve unpackCurve quantised curveMaps curveSvg curveCsv
  interpolation sampleGraph graphAt graphFacts toRecurrent`;

describe("the package", () => {
  beforeAll(() =>
    init({
      frond: read("frond_bg.wasm"),
      curve: read("frond-curve_bg.wasm"),
      proof: read("frond-proof_bg.wasm"),
    }),
  );

  it("exports all that is promised, from whichever module", () => {
    const missing = PROMISED.split(/\s+/).filter(
      (name) => typeof (frond as Record<string, unknown>)[name] !== "function",
    );
    expect(missing).toEqual([]);
  });

  it("hands what one module gives to the other", () => {
    const dust = frond.presets().find(({ id }) => id === "dust");
    if (!dust) throw new Error("there is no dust");
    expect(frond.connectedness(dust, { epsilon: 1e-6 }).verdict).toBe("disconnected");
    expect(() => frond.connectedness({ maps: [] }, undefined)).toThrowError(
      expect.objectContaining({ code: "no-maps" }),
    );
  });

  it("finds its modules by itself in Node", async () => {
    const entry: string = "../../www/pkg/node.js";
    const node = await import(/* @vite-ignore */ entry);
    await node.default();
    expect(node.presets().length).toBeGreaterThan(10);
  });
});
