import { expect, test } from "vitest";
import { STATE } from "#geometry/states";
import { mapDrawing } from "./drawing";

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
