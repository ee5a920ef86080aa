import { expect, test } from "vitest";
import { STATE } from "#geometry/states";
import { drawAxes, MARGIN, mapDrawing, outlinesOf } from "./drawing";

const window = { u0: -1, u1: 2, v0: -1, v1: 2 };
const field = {
  width: 4,
  height: 4,
  bounds: window,
  // The lowest row is in one piece, all above it is broken, ever wider; one sample is not known yet.
  state: Uint8Array.from({ length: 16 }, (_, i) =>
    i < 4 ? STATE.connected : i === 15 ? STATE.pending : STATE.disconnected,
  ),
  gap: Float32Array.from({ length: 16 }, (_, i) => (i < 8 ? 0.01 : 0.5)),
};
const map = {
  title: "Fern & tree",
  window,
  names: { across: "u", up: "v" },
  areas: { field, style: "gap" as const, epsilon: 1 / 600 },
  path: { whole: "M33 67L67 33", broken: "M40 60L50 50", faint: "", faintBroken: "" },
  ends: [{ letter: "A", at: [1 / 3, 2 / 3] as const }],
};
const count = (text: string, part: RegExp) => text.match(part)?.length ?? 0;

test("a map is a path for each answer and shade, with axes, the path and its ends", () => {
  const text = mapDrawing(map);
  expect(text).toContain("<title>Fern &amp; tree</title>");
  // In one piece, and two shades of the gap.
  expect(text).toContain("<desc>3 areas, the path, u from -1 to 2, v from -1 to 2. Made by Frond.</desc>");
  expect(count(text, /crispEdges/g)).toBe(3);
  // v points up: what holds lies at the foot, half a sample high, and reaches over the sides, where it is cut.
  expect(text).toContain('d="M-266.67 1866.67L1866.67 1866.67L1866.67 1333.33L-266.67 1333.33Z"');
  // Four numbers and a name a side, and an end.
  expect(count(text, /<text /g)).toBe(4 + 1 + 4 + 1 + 1);
  expect(count(text, /stroke-dasharray/g)).toBe(1);
  expect(count(text, /<svg/g)).toBe(3);
  expect(text).not.toMatch(/NaN|undefined|Infinity/);
  const plain = mapDrawing({ ...map, areas: { ...map.areas, style: "yesno" } });
  expect(count(plain, /crispEdges/g)).toBe(2);
});

test("the path alone is drawn on the same axes", () => {
  const { areas: _areas, ...rest } = map;
  const text = mapDrawing(rest);
  expect(count(text, /crispEdges/g)).toBe(0);
  expect(text).toContain('d="M33 67L67 33"');
  expect(count(text, /<text /g)).toBe(11);
});

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

/** Remembers what is written, and where. */
function pen() {
  const written: [string, number, number][] = [];
  const nothing = () => {};
  const context = {
    fillRect: nothing,
    strokeRect: nothing,
    beginPath: nothing,
    moveTo: nothing,
    lineTo: nothing,
    stroke: nothing,
    fillText: (text: string, x: number, y: number) => void written.push([text, x, y]),
    fillStyle: "",
    strokeStyle: "",
    lineWidth: 0,
    font: "",
    textAlign: "left" as CanvasTextAlign,
    textBaseline: "top" as CanvasTextBaseline,
  };
  return { context, written };
}

test("numbers stand where they are, v upwards, and both axes are named", () => {
  const { context, written } = pen();
  drawAxes(context, 300, { u0: -1, u1: 2, v0: -1, v1: 2 }, { across: "u", up: "v" }, () => {});
  const across = written
    .filter(([, , y]) => y > MARGIN.top + 300)
    .map(([text, x]) => [text, x - MARGIN.left]);
  expect(across).toEqual([
    ["−1", 0],
    ["0", 100],
    ["1", 200],
    ["2", 300],
    ["u", 150],
  ]);
  const up = written.slice(across.length).map(([text, , y]) => [text, y - MARGIN.top]);
  expect(up).toEqual([
    ["−1", 300],
    ["0", 200],
    ["1", 100],
    ["2", 0],
    ["v", 150],
  ]);
});
