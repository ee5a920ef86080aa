import { quantize } from "gifenc";
import { expect, it } from "vitest";
import { type Colour, indexed, matcher, paletteOf } from "./gif-colours";

const GROUND: Colour = [251, 250, 246];
const picture = (colours: readonly Colour[]) =>
  Uint8ClampedArray.from(colours.flatMap((colour) => [...colour, 255]));

/** Flat colours with edges towards the ground and each other, as a picture of so many samples a pixel has. */
function flat(samples: number): Colour[] {
  const own: Colour[] = [[0, 114, 178], [0, 131, 95], [145, 133, 0], [190, 90, 20], GROUND];
  const edges = own.flatMap((p) =>
    own.flatMap((q) =>
      Array.from({ length: samples - 1 }, (_, k): Colour => {
        const mixed = (i: 0 | 1 | 2) => Math.round(p[i] + ((q[i] - p[i]) * (k + 1)) / samples);
        return [mixed(0), mixed(1), mixed(2)];
      }),
    ),
  );
  return [...own.flatMap((colour) => Array.from({ length: 500 }, () => colour)), ...edges];
}

it("keeps every colour of a flat picture exactly, without dots", () => {
  const pixels = picture(flat(4));
  const { colours, rough } = paletteOf(pixels, GROUND, 255, quantize);
  expect([colours[0], rough]).toEqual([GROUND, false]);
  const shown = [...indexed(pixels, matcher(colours))].map((i) => colours[i]);
  expect(shown).toEqual(flat(4));
});

it("keeps the flat colours exactly where their edges have too many, and asks for no dots", () => {
  const { colours, rough } = paletteOf(picture(flat(60)), GROUND, 255, quantize);
  expect([colours.length <= 255, rough]).toEqual([true, false]);
  for (const own of flat(60).slice(0, 2500)) expect(colours).toContainEqual(own);
  // Whatever becomes of the others.
  const grey = () => [[99, 99, 99]];
  const { colours: few } = paletteOf(picture(flat(60)), GROUND, 255, grey);
  for (const own of [GROUND, [0, 114, 178], [190, 90, 20]]) expect(few).toContainEqual(own);
});

it("asks for dots where many shades run into each other", () => {
  const shades = Array.from({ length: 64 * 64 }, (_, i): Colour => [4 * (i % 64), 4 * (i >> 6), 128]);
  const { colours, rough } = paletteOf(picture(shades), null, 255, quantize);
  expect([colours.length, rough]).toEqual([255, true]);
});

it("gives a colour the same index in every frame, whatever was there before", () => {
  const colours: Colour[] = [
    [0, 0, 0],
    [10, 0, 0],
    [200, 0, 0],
  ];
  const [forth, back] = [matcher(colours), matcher(colours)];
  const reds = Array.from({ length: 256 }, (_, red) => red);
  const found = reds.map((red) => forth(red, 0, 0));
  expect([...reds].reverse().map((red) => back(red, 0, 0))).toEqual([...found].reverse());
  expect([found[0], found[10], found[90], found[120], found[255]]).toEqual([0, 1, 1, 2, 2]);
});

it("makes do with one pixel", () => {
  expect(paletteOf(new Uint8ClampedArray(4), null, 255, quantize).colours).toEqual([[0, 0, 0]]);
});
