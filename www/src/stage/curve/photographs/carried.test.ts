import { expect, it } from "vitest";
import { gridOf, paintGrid } from "./carried";

const square = Float64Array.of(-1, -1, 1, -1, 1, 1, -1, 1);
const small = square.map((z) => z / 2);
const BOX = [-1, -1, 1, 1] as const;

/** Each column of another shade. */
function ramp(box: readonly [number, number, number, number], left: number, step: number) {
  const data = Uint8ClampedArray.from({ length: 4 * 64 }, (_, i) =>
    i % 4 === 3 ? 255 : left + step * ((i >> 2) % 8),
  );
  return { data, width: 8, height: 8, box };
}

it("shows either leaf at its end, and both between, each where its outline carries it", () => {
  // The second leaf is half as large: its picture lies on half of the box.
  const textures = [ramp(BOX, 0, 10), ramp([-0.5, -0.5, 0.5, 0.5], 200, -20)] as const;
  const seen = (s: number, ring: Float64Array, box: readonly [number, number, number, number]) => {
    const pixels = { data: new Uint8ClampedArray(4 * 64), width: 8, height: 8 } as ImageData;
    paintGrid(pixels, gridOf(ring, [square, small], box, 2, 4, 4), textures, s);
    return [0, 2, 7].map((x) => pixels.data[4 * (x + 8 * x)]);
  };
  expect(seen(0, square, BOX)).toEqual([0, 20, 70]);
  expect(seen(1, small, [-0.5, -0.5, 0.5, 0.5])).toEqual([200, 160, 60]);
  const half = square.map((z) => 0.75 * z);
  expect(seen(0.5, half, [-0.75, -0.75, 0.75, 0.75])).toEqual([100, 90, 65]);
});
