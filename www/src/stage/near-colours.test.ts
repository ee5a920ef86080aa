import { expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { nearColours } from "./near-colours";

const BOX = { x0: 0, y0: 0, x1: 1, y1: 1 };
const half = (x: number, y: number, side = 0.5): MapRow => [side, 0, 0, side, x, y];
const RGB = ["#ff0000", "#00ff00", "#0000ff"];

it("leaves the colours alone where maps are apart", () => {
  expect(nearColours([half(0, 0), half(0.5, 0), half(0, 0.5)], RGB, BOX, 1000)).toBe(RGB);
  // Four pixels and more, in one corner of the box alone.
  expect(nearColours([half(0, 0), half(0, 0, 0.504)], RGB, BOX, 1000)).toBe(RGB);
});

it("gives maps that coincide the colour of the last one, which is seen", () => {
  expect(nearColours([half(0, 0), half(0.5, 0), half(0, 0)], RGB, BOX, 1000)).toEqual([
    "#0000ff",
    "#00ff00",
    "#0000ff",
  ]);
  expect(nearColours([half(0, 0), half(0, 0), half(0, 0)], RGB, BOX, 1000)).toEqual(Array(3).fill("#0000ff"));
});

it("fades from one colour into the other as they come near", () => {
  const reds = [5, 4, 3, 2, 1, 0].map((pixels) => {
    const [first] = nearColours([half(pixels / 1000, 0), half(0, 0)], RGB, BOX, 1000);
    return Number.parseInt(first?.slice(1, 3) ?? "", 16);
  });
  expect([reds[0], reds[1], reds[4], reds[5]]).toEqual([255, 255, 0, 0]);
  expect(reds[2]).toBeGreaterThan(reds[3] ?? 255);
  expect(reds[3]).toBeGreaterThan(0);
});

it("goes on with the colours of the palette in turn", () => {
  const maps = [half(0, 0), half(0.5, 0), half(0, 0.5), half(0.5, 0.5), half(0, 0)];
  expect(nearColours(maps, RGB, BOX, 100)).toEqual(["#00ff00", "#00ff00", "#0000ff", "#ff0000", "#00ff00"]);
});
