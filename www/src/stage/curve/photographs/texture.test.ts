import { expect, it } from "vitest";
import { filled } from "./texture";

/** A picture of one row. */
const row = (...pixels: [number, number, number, number][]) =>
  ({ data: Uint8ClampedArray.from(pixels.flat()), width: pixels.length, height: 1 }) as ImageData;

it("goes on with the colour that is near, and leaves what is there", () => {
  const clear: [number, number, number, number] = [9, 9, 9, 0];
  const part = row([200, 0, 0, 255], clear, clear, [0, 0, 100, 255]);
  const out = filled(part, part.data);
  expect([...out.slice(0, 4)]).toEqual([200, 0, 0, 255]);
  expect([...out.slice(4, 8)]).toEqual([200, 0, 0, 255]);
  expect([...out.slice(8, 12)]).toEqual([0, 0, 100, 255]);
  expect([...out.slice(12)]).toEqual([0, 0, 100, 255]);
});

it("fills all of a picture that has one pixel, of any size", () => {
  for (const [width, height] of [
    [1, 1],
    [5, 3],
    [7, 16],
  ] as const) {
    const data = new Uint8ClampedArray(4 * width * height);
    data.set([10, 20, 30, 255], data.length - 4);
    const out = filled({ data, width, height } as ImageData, data);
    for (let i = 0; i < out.length; i += 4) expect([...out.slice(i, i + 4)]).toEqual([10, 20, 30, 255]);
  }
});

it("leaves the rim where it is, and does not go on with it", () => {
  const clear: [number, number, number, number] = [0, 0, 0, 0];
  const leaf: [number, number, number, number] = [200, 0, 0, 255];
  const rim: [number, number, number, number] = [250, 250, 250, 255];
  const out = filled(row(leaf, clear, clear, clear), row(leaf, rim, clear, clear).data);
  expect([...out]).toEqual([...leaf, ...rim, ...leaf, ...leaf]);
});
