import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import initCurve, * as curve from "../../www/pkg/frond-curve.js";
import init, * as fit from "../../www/pkg/frond-fit.js";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** A fit takes a second or two; on a busy machine minutes. */
const SLOW_MS = 300_000;

/** A flower with petals that meet in corners. */
const flower = Float64Array.from(
  Array.from({ length: 600 }, (_, i) => {
    const angle = (Math.PI * i) / 300;
    const r = 100 + 40 * Math.abs(Math.sin(2.5 * angle));
    return [7 + r * Math.cos(angle), r * Math.sin(angle) - 3];
  }).flat(),
);

const codeOf = (work: () => unknown) => {
  try {
    work();
    return "none";
  } catch (problem) {
    return (problem as { code: string }).code;
  }
};

describe("a fit within so many bytes", () => {
  let found: ReturnType<typeof fit.fitWithin>;
  const shares: number[] = [];
  const errors: number[] = [];

  beforeAll(async () => {
    await Promise.all([
      init({ module_or_path: read("frond-fit_bg.wasm") }),
      initCurve({ module_or_path: read("frond-curve_bg.wasm") }),
    ]);
    // Step by step, as `fitWithin` does it at once.
    const handle = new fit.SplineFit(flower, 60);
    for (;;) {
      const { share, done } = handle.step(1);
      shares.push(share);
      const best = handle.best();
      if (best) errors.push(best.rms);
      if (done) break;
    }
    found = handle.measured();
    handle.free();
  }, SLOW_MS);

  it(
    "keeps within them, and no other way to spend them comes much nearer",
    () => {
      expect(found.bytes.length).toBeLessThanOrEqual(60);
      expect(found.corners + found.bends).toBeGreaterThan(8);
      for (const method of ["squares", "bezier", "fourier"]) {
        const other = fit.rivalWithin(flower, method, 60);
        expect(other?.points.length).toBeGreaterThan(20);
        // Of polylines it holds without a margin: they compete in it.
        expect(found.figures.rms).toBeLessThan((other?.rms ?? 0) * (method === "squares" ? 1.000_001 : 1.3));
      }
    },
    SLOW_MS,
  );

  it("is unpacked from its bytes and from its word", () => {
    const there = curve.unpackSpline(found.word);
    expect(curve.unpackSpline(found.bytes)).toEqual(there);
    expect(there.bytes).toBe(found.bytes.length);
    expect(there.points).toEqual(found.points);
    expect(there.nodes.filter(({ on }) => on)).toHaveLength(found.corners);
    expect(there.nodes).toHaveLength(found.corners + found.bends);
    for (const { at } of there.nodes)
      for (const x of at) expect(x / there.grid).toBe(Math.round(x / there.grid));
    expect(there.path.split("Q").length - 1).toBe(found.bends);
    expect(found.word).toHaveLength(Math.ceil((4 * found.bytes.length) / 3));
    expect(fit.measureSpline(flower, found.word)).toEqual(found);
  });

  it("comes ever nearer on the way", () => {
    expect(shares.length).toBeGreaterThan(20);
    expect(shares).toEqual([...shares].sort((a, b) => a - b));
    expect(errors).toEqual([...errors].sort((a, b) => b - a));
    expect(errors.at(-1)).toBe(found.figures.rms);
  });

  it("becomes a drawing of true parabolas, and a closed curve", () => {
    const svg = curve.splineSvg(found.word, { size: 300, fill: "none" });
    expect(svg.split("Q").length - 1).toBe(found.bends);
    expect(svg).toContain('height="300"');
    const polygon = curve.splineCurve(found.bytes);
    expect(polygon.edges.every((edge) => edge === null)).toBe(true);
    expect(polygon.knots.length).toBeGreaterThan(found.corners + found.bends);
    const figures = fit.measureCurve(flower, polygon) as { figures: { rms: number } };
    // Its sides leave the curve by an eighth of a step of the grid at most: that is how far the two can be apart.
    const sides = [0, 1].map((axis) => flower.filter((_, i) => i % 2 === axis));
    const diagonal = Math.hypot(...sides.map((all) => Math.max(...all) - Math.min(...all)));
    const step = (100 * curve.unpackSpline(found.word).grid) / diagonal;
    expect(Math.abs(figures.figures.rms - found.figures.rms)).toBeLessThan(step / 8);
  });

  it("says what is wrong", () => {
    expect(codeOf(() => fit.fitWithin(flower, 31))).toBe("bad-input");
    expect(codeOf(() => fit.fitWithin(flower, 4001))).toBe("bad-input");
    expect(codeOf(() => fit.fitWithin(new Float64Array(3), 50))).toBe("bad-input");
    expect(codeOf(() => fit.rivalWithin(flower, "spirals", 50))).toBe("bad-input");
    expect(codeOf(() => curve.unpackSpline(""))).toBe("unknown-version");
    expect(codeOf(() => curve.unpackSpline("????"))).toBe("unsound");
    expect(codeOf(() => curve.unpackSpline(found.word.slice(0, 12)))).toMatch(/none|unsound/);
    expect(codeOf(() => curve.unpackSpline(new Uint8Array(1 << 20)))).toBe("too-large");
    expect(codeOf(() => curve.unpackSpline(7 as unknown as string))).toBe("bad-input");
    expect(codeOf(() => curve.splineSvg(found.word, { size: 3 }))).toBe("bad-input");
    expect(codeOf(() => curve.splineSvg(found.word, { fill: "red" }))).not.toBe("none");
    // So far out that the first place alone takes too many bytes.
    const far = flower.map((x) => x + 1e15);
    expect(codeOf(() => fit.fitWithin(far, 32))).toBe("no-fit");
  });
});
