import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as fit from "../../www/pkg/frond-fit.js";

const SIDE = 240;

/** A dark flower on white, as a picture. */
function flower(): Uint8Array {
  const pixels = new Uint8Array(4 * SIDE * SIDE).fill(255);
  for (let y = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++) {
      const [dx, dy] = [x + 0.5 - SIDE / 2, y + 0.5 - SIDE / 2];
      const radius = 80 + 12 * Math.cos(5 * Math.atan2(dy, dx));
      if (Math.hypot(dx, dy) < radius) pixels.fill(40, 4 * (y * SIDE + x), 4 * (y * SIDE + x) + 3);
    }
  }
  return pixels;
}

/** A fractal function of two maps at 2^k + 1 points: T1 and T2 in turn, from their fixed points. */
function graph(k: number): Float64Array {
  const maps = [
    [0.5, 0.746, 0.5, -0.5, 0.246],
    [0.5, -0.199, -0.6, 0.5, 0.189],
  ] as const;
  const image = (map: readonly number[], [t = 0, x = 0]: readonly number[]): [number, number] => {
    const [a = 0, b = 0, c = 0, d = 0, e = 0] = map;
    return [a * t + d, b * t + c * x + e];
  };
  const fixed = maps.map(([a, b, c, d, e]): [number, number] => {
    const t = d / (1 - a);
    return [t, (b * t + e) / (1 - c)];
  });
  let points: [number, number][] = fixed;
  for (let i = 0; i < k; i++) {
    const [left, right] = maps.map((map) => points.map((point) => image(map, point)));
    points = [...(left ?? []), ...(right ?? []).slice(1)];
  }
  return Float64Array.from(points.flat());
}

describe("the package of the fit", () => {
  beforeAll(async () => {
    await init({ module_or_path: readFile(new URL("../../www/pkg/frond-fit_bg.wasm", import.meta.url)) });
  });

  it("goes from a picture to a closed curve", () => {
    const outline = fit.traceOutline(flower(), SIDE, SIDE, undefined) as unknown as {
      points: Float64Array;
      area: number;
    };
    expect(outline.area / (Math.PI * (80 * 80 + 72))).toBeCloseTo(1, 2);
    const closed = fit.fitCurve(outline.points, { numbers: 60 }) as unknown as {
      curve: { knots: unknown[]; edges: unknown[] };
      bytes: number;
    };
    const copies = closed.curve.edges.filter((edge) => edge !== null).length;
    expect(2 * (closed.curve.knots.length + copies)).toBeLessThanOrEqual(60);
    expect(closed.bytes).toBeGreaterThan(40);
    const collage = fit.fitCurve(outline.points, { model: "collage", maps: 12, features: 60 }) as unknown as {
      maps: unknown[];
      widest: number;
    };
    expect(collage.maps).toHaveLength(12);
    // Ten numbers a map, eight where x and y are copied apart (section 3.2).
    const options = { model: "collage", maps: 12, features: 60 } as const;
    const numbersOf = (separable: boolean) =>
      (fit.fitCurve(outline.points, { ...options, separable }) as unknown as { numbers: number }).numbers;
    expect([numbersOf(false), numbersOf(true)]).toEqual([120, 96]);
    expect(collage.widest).toBeGreaterThan(0);
  });

  it("finds the maps of a graph", () => {
    const { found } = fit.houghMaps(graph(4), graph(5), undefined) as unknown as {
      found: { map: number[]; kind: string }[];
    };
    const near = (map: number[]) =>
      found
        .slice(0, 4)
        .some((cluster) => cluster.map.every((value, i) => Math.abs(value - (map[i] ?? 0)) < 0.04));
    expect(near([0.5, 0.746, 0.5, -0.5, 0.246])).toBe(true);
    expect(near([0.5, -0.199, -0.6, 0.5, 0.189])).toBe(true);
  });

  it("says what is wrong", () => {
    const code = (work: () => unknown) => {
      try {
        work();
        return "none";
      } catch (problem) {
        return (problem as { code: string }).code;
      }
    };
    const white = new Uint8Array(4 * SIDE * SIDE).fill(255);
    expect(code(() => fit.traceOutline(white, SIDE, SIDE, undefined))).not.toBe("none");
    expect(code(() => fit.fitCurve(new Float64Array([0, 0, 1, 0]), undefined))).not.toBe("none");
    expect(code(() => fit.fitCurve(new Float64Array(3), undefined))).toBe("bad-input");
    expect(code(() => fit.fitCurve(new Float64Array(20), { model: "willow" as "closed" }))).toBe("bad-input");
    expect(code(() => fit.houghMaps(new Float64Array(4), new Float64Array(4), undefined))).not.toBe("none");
  });
});
