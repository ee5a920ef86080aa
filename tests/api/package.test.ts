import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as frond from "../../www/pkg/index.js";
import type { MapRow } from "../../www/src/wasm/api";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** What docs/package.md promises of the package's first entry. */
const PROMISED = `presets validate attractor rasterize bounds connectedness hausdorffDistance certificate connectedCertificate checkCertificate indexBuffer
  barnsleyTest pair interpolate halfTurns locus LocusTiles planPath planPathIn checkPath certifyPath candidates rateCandidate routes ways
  familyMaps criticalScale FamilyTiles PathSearch conjugate polar encodeScene decodeScene defaultScene settleLocus settleFamily
  CurveMorph curvePresets curveFacts packCurve unpackCurve quantised curveMaps curveCopies curveSteps curveSvg curveCsv
  interpolation sampleGraph graphAt graphFacts toRecurrent
  interpolationCurve sampleInterpolationCurve`;

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

  it("looks through a window of the plane for pieces in one pixel, and says what is wrong with one", () => {
    const height = Math.sqrt(0.75);
    const corners: [number, number][] = [
      [0, 0],
      [0.5, 0],
      [0.25, height / 2],
    ];
    const gasket: frond.Ifs = { maps: corners.map(([e, f]) => [0.5, 0, 0, 0.5, e, f]) };
    const options = { size: 150, points: 1_000_000, seed: 1 };
    // Its pieces touch on a border between pixels, unless the window is off the middle.
    expect(frond.indexBuffer(gasket, options).connected).toBe(false);
    const [x, y, side] = [-0.0271, height / 2 - 0.5271, 1.05];
    const seen = frond.indexBuffer(gasket, { ...options, window: [x, y, x + side, y + side] });
    expect(seen).toMatchObject({ connected: true, count: 1 });
    const refused = (window: number[]) => {
      try {
        frond.indexBuffer(gasket, { ...options, window: window as [number, number, number, number] });
        return "";
      } catch (problem) {
        const { code, message } = problem as { code: string; message: string };
        return `${code}: ${message}`;
      }
    };
    expect(refused([1, 0, 0, 1])).toMatch(
      /^index-buffer-window: .*lower left corner and then the upper right/,
    );
    expect(refused([0, 0, Number.NaN, 1])).toMatch(/^index-buffer-window: /);
    expect(refused([0, 0, 1])).toMatch(/^bad-input: /);
  });

  it("measures how far two shapes are from each other, between bounds", () => {
    const scaled = (size: number, ...places: number[]) => ({
      maps: places.map((place): MapRow => [size, 0, 0, size, place, 0]),
    });
    // The middle of a segment is farthest from Cantor's dust: 1/6.
    const [dust, segment] = [scaled(1 / 3, 0, 2 / 3), scaled(0.5, 0, 0.5)];
    const { lower, upper, points } = frond.hausdorffDistance(segment, dust, { tolerance: 1e-6 });
    expect(lower).toBeLessThanOrEqual(1 / 6);
    expect(upper).toBeGreaterThanOrEqual(1 / 6);
    expect(upper - lower).toBeLessThan(1e-5);
    expect(points[0][0]).toBeCloseTo(0.5, 5);
    expect(() => frond.hausdorffDistance(dust, segment, { tolerance: 0 })).toThrowError(
      expect.objectContaining({ code: "bad-input" }),
    );
  });

  it("hands what one module gives to the other", () => {
    const dust = frond.presets().find(({ id }) => id === "dust");
    if (!dust) throw new Error("there is no dust");
    expect(frond.connectedness(dust, { epsilon: 1e-6 }).verdict).toBe("disconnected");
    expect(() => frond.connectedness({ maps: [] }, undefined)).toThrowError(
      expect.objectContaining({ code: "no-maps" }),
    );
  });
});
