import { expect, it } from "vitest";
import { planesOf } from "./yuv";

type Rgb = readonly [red: number, green: number, blue: number];
const pixels = (...colours: Rgb[]) => Uint8ClampedArray.from(colours.flatMap((colour) => [...colour, 255]));

/** Back to colours, by the inverse that players use (BT.709). */
function seen([y = 0, u = 0, v = 0]: number[]): number[] {
  const [bright, cb, cr] = [(y - 16) / 219, (u - 128) / 224, (v - 128) / 224];
  return [bright + 1.5748 * cr, bright - 0.187324 * cb - 0.468124 * cr, bright + 1.8556 * cb].map(
    (channel) => 255 * channel,
  );
}

const COLOURS: Rgb[] = [
  [0, 0, 0],
  [255, 255, 255],
  [255, 0, 0],
  [0, 255, 0],
  [0, 0, 255],
  [0, 114, 178],
  [251, 250, 246],
  [145, 133, 0],
];

it("has the values of the recommendation at its ends", () => {
  const made = planesOf(pixels([0, 0, 0], [255, 255, 255], [0, 0, 255], [255, 0, 0]), 2, 2, "444");
  expect([...made]).toEqual([16, 235, 32, 63, 128, 128, 240, 102, 128, 128, 118, 240]);
});

it("is the same colour for players, in every pixel of its own or in four alike", () => {
  for (const colour of COLOURS) {
    const four = pixels(colour, colour, colour, colour);
    const full = planesOf(four, 2, 2, "444");
    const half = planesOf(four, 2, 2, "420");
    expect([full.length, half.length]).toEqual([12, 6]);
    expect([...half]).toEqual([full[0], full[1], full[2], full[3], full[4], full[8]]);
    seen([half[0] ?? 0, half[4] ?? 0, half[5] ?? 0]).forEach((channel, k) => {
      expect(Math.abs(channel - (colour[k] ?? 0))).toBeLessThan(2);
    });
  }
});

it("keeps the colour of each pixel where there is room for it, and else their mean", () => {
  const red: Rgb = [200, 40, 30];
  const blue: Rgb = [20, 60, 210];
  const four = pixels(red, blue, blue, red);
  const full = planesOf(four, 2, 2, "444");
  for (const [k, colour] of [red, blue, blue, red].entries()) {
    seen([full[k] ?? 0, full[4 + k] ?? 0, full[8 + k] ?? 0]).forEach((channel, c) => {
      expect(Math.abs(channel - (colour[c] ?? 0))).toBeLessThan(2);
    });
  }
  const half = planesOf(four, 2, 2, "420");
  expect(Math.abs((half[4] ?? 0) - ((full[4] ?? 0) + (full[5] ?? 0)) / 2)).toBeLessThan(1);
  // A wide picture: its rows follow each other.
  const wide = planesOf(pixels(red, red, blue, blue, red, red, blue, blue), 4, 2, "420");
  const [a, b] = [red, blue].map((colour) => planesOf(pixels(colour, colour, colour, colour), 2, 2, "420"));
  expect([...wide.subarray(8)]).toEqual([a?.[4], b?.[4], a?.[5], b?.[5]]);
});
