import { expect, test } from "vitest";
import { outlinesOf } from "./areas";

/** Whether a point is within polygons, even-odd. */
function inside(polygons: readonly number[][], px: number, py: number): boolean {
  let odd = false;
  for (const corners of polygons) {
    for (let i = 0; i < corners.length; i += 2) {
      const j = (i + 2) % corners.length;
      const [x0, y0, x1, y1] = [corners[i], corners[i + 1], corners[j], corners[j + 1]] as [
        number,
        number,
        number,
        number,
      ];
      if (y0 > py !== y1 > py && px < x0 + ((py - y0) / (y1 - y0)) * (x1 - x0)) odd = !odd;
    }
  }
  return odd;
}

test("every cell lies within the outline of its class, and of no other", () => {
  // Rings, diagonal neighbours, single cells, rows and columns.
  let seed = 7;
  const random = () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647;
  };
  for (const [width, height, kinds] of [
    [9, 7, 2],
    [8, 8, 3],
    [1, 6, 2],
    [6, 1, 4],
    [1, 1, 1],
  ] as const) {
    for (let round = 0; round < 20; round++) {
      const classes = Uint8Array.from({ length: width * height }, () => Math.floor(kinds * random()));
      const outlines = outlinesOf(classes, width, height);
      classes.forEach((own, i) => {
        const [x, y] = [(i % width) + 0.5, Math.floor(i / width) + 0.5];
        for (const [one, polygons] of outlines) expect(inside(polygons, x, y)).toBe(one === own);
      });
    }
  }
});

test("an even area has four corners, and one with a hole two outlines", () => {
  expect(outlinesOf([3, 3, 3, 3, 3, 3], 3, 2).get(3)).toEqual([[0, 0, 3, 0, 3, 2, 0, 2]]);
  const ring = [1, 1, 1, 1, 0, 1, 1, 1, 1];
  expect(outlinesOf(ring, 3, 3).get(1)).toHaveLength(2);
});
