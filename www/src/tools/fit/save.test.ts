import { expect, test } from "vitest";
import { curveJson } from "#format/curve-files";
import type { Collage } from "#workers/fit/curve";
import { collageCsv, collageJson, collageSvg } from "./save";

const collage: Collage = {
  points: new Float64Array([0, 0, 1, 0, 1, 1, 0, 1]),
  starts: new Float64Array([0, 2, 4]),
  gaps: new Float64Array([1, 0, 1, 1]),
  widest: 1,
  mean: 0.5,
  collage: 0,
  numbers: 20,
  maps: [
    [4, 1, 0.1, 0.2, 0.3, 0.4, 5, 6, 7, 8],
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
  ],
  figures: { rms: 1, hausdorff: 2, lengthRatio: 1, outlineSlope: 1, fitSlope: 1 },
};

test("edges have their maps beside them, straight ones none", () => {
  const text = curveJson(
    "Leaf",
    {
      knots: [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
      edges: [null, { from: 2, span: 2, reversed: true, c: -0.5 }, null],
    },
    [
      { map: null, arc: [0, 1], reversed: false },
      { map: [0.5, 0, 0, 0.5, 1 / 3, 0], arc: [2, 2], reversed: true },
      { map: null, arc: [2, 1], reversed: false },
    ],
    null,
  );
  const back = JSON.parse(text);
  expect(back.edges).toEqual([
    null,
    { from: 2, span: 2, reversed: true, c: -0.5, map: [0.5, 0, 0, 0.5, 0.333333333, 0] },
    null,
  ]);
  expect(back.knots).toHaveLength(3);
});

test("pieces stay pieces", () => {
  expect(collageCsv(collage)).toBe("x,y,piece\n0,0,1\n1,0,1\n1,1,2\n0,1,2\n");
  expect(collageSvg(collage).match(/<path/g)).toHaveLength(2);
  expect(collageSvg(collage)).toContain('d="M0 0L500 0"');
  const options = { maps: 2, features: 4, separable: false, tied: false, partitioned: false };
  const { maps } = JSON.parse(collageJson("Leaf", options, collage));
  expect(maps[0]).toEqual({
    start: 4,
    reversed: true,
    c: [
      [0.1, 0.2],
      [0.3, 0.4],
    ],
    b: [5, 6],
    e: [7, 8],
  });
});
