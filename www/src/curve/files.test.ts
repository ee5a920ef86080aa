import { describe, expect, it } from "vitest";
import { csvOf, jsonOf, nameOf, svgOf } from "./files";

const TRIANGLE = [0, 0, 2, 0, 0, 1];
const shape = (name: string) => ({
  name,
  curve: {
    knots: [
      [0, 0],
      [2, 0],
      [0, 1],
    ] as [number, number][],
    edges: [null, { from: 1, span: 2, reversed: true, c: -0.25 }, null],
  },
});

describe("a curve as a file", () => {
  it("is drawn a thousand units long with y down, closed", () => {
    const svg = svgOf(TRIANGLE, { title: "a <b> & c", colour: "#123456" });
    expect(svg).toContain('viewBox="0 0 1040 540"');
    expect(svg).toContain('d="M20 520L1020 520L20 20Z"');
    expect(svg).toContain("<title>a &lt;b&gt; &amp; c</title>");
    expect(svg.match(/<(?!\/|\?)\w+/g)).toEqual(["<svg", "<title", "<path"]);
  });

  it("is drawn where it has no size, and where it has no points", () => {
    for (const points of [[], [1, 1], [1, 1, 1, 1]])
      expect(svgOf(points, { title: "", colour: "#000000" })).not.toMatch(/NaN|Infinity/);
  });

  it("is a line a point", () => {
    expect(csvOf([0.1, -2, 1 / 3, 1e-9])).toBe("x,y\n0.1,-2\n0.3333333,1e-9\n");
  });

  it("holds both ends with the maps of their edges", () => {
    const maps = { a: [null, [0.5, 0, 0, 0.5, 1, 0], null], b: [null, null, null] } as const;
    const rows = (of: readonly (readonly number[] | null)[]) =>
      of.map((map, i) => ({ map: map as never, arc: [i, 1] as [number, number], reversed: false }));
    const text = jsonOf({
      curves: { a: shape("A"), b: shape("B") },
      maps: { a: rows(maps.a), b: rows(maps.b) },
      s: 0.25,
      bend: null,
      points: TRIANGLE,
    });
    const read = JSON.parse(text);
    expect(read.s).toBe(0.25);
    expect(read.bend).toBeUndefined();
    expect(read.a.knots).toEqual(shape("A").curve.knots);
    expect(read.a.edges).toEqual([
      null,
      { from: 1, span: 2, reversed: true, c: -0.25, map: [0.5, 0, 0, 0.5, 1, 0] },
      null,
    ]);
    expect(read.outline).toEqual([
      [0, 0],
      [2, 0],
      [0, 1],
    ]);
  });

  it("is named by what it shows", () => {
    const both = { a: shape("Maple leaf"), b: shape("Ö? / oak!") };
    expect(nameOf(both, 0, "svg")).toBe("frond-maple-leaf.svg");
    expect(nameOf(both, 0.5, "csv")).toBe("frond-maple-leaf-ö-oak-0.50.csv");
    expect(nameOf(both, 1, "png")).toBe("frond-ö-oak.png");
    expect(nameOf(null, 0, "json")).toBe("frond-curve.json");
  });
});
