import { describe, expect, it } from "vitest";
import { cellOf, codeOf, shuffled } from "../codes/codes";
import { shade, thirds } from "../deformations/meshes";
import { digitsReversed, LETTERS, meanParts, type Subject, shuffledImage } from "./shuffled-image";

const SQUARE = { dimensions: 2, parts: 2 } as const;
const SIDE = 2 ** LETTERS;

const pixel = (subject: Subject, kb: number, ke: number, superposed: boolean, [x, y]: [number, number]) => {
  const { pixels } = shuffledImage(subject, kb, ke, superposed);
  const at = 4 * ((SIDE - 1 - y) * SIDE + x);
  return [...pixels.slice(at, at + 4)];
};

describe("an image after a shuffle", () => {
  it("has in each cell the colour of the cell whose code is reversed", () => {
    const cells: [number, number][] = [
      [3, 77],
      [127, 0],
      [64, 64],
      [90, 33],
    ];
    for (const [kb, ke] of [
      [0, 5],
      [1, 4],
      [2, 5],
      [0, 1],
    ] as const) {
      for (const [x, y] of cells) {
        const code = codeOf(SQUARE, [(x + 0.5) / SIDE, (y + 0.5) / SIDE], LETTERS);
        const { corner, side } = cellOf(SQUARE, shuffled(code, kb, ke));
        const [u = 0, v = 0] = corner.map((low) => low + side / 2);
        expect(digitsReversed(x, kb, ke)).toBe(Math.floor(u * SIDE));
        expect(pixel("square", kb, ke, false, [x, y])).toEqual([...shade(thirds(u, v)), 255]);
      }
    }
  });

  it("is as it was where nothing is reversed", () => {
    const plain = shuffledImage("square", 0, 0, false).pixels;
    for (const [kb, ke] of [
      [0, 1],
      [2, 2],
      [2, 3],
    ] as const) {
      expect(shuffledImage("square", kb, ke, false).pixels).toEqual(plain);
    }
    expect(shuffledImage("square", 0, 2, false).pixels).not.toEqual(plain);
  });

  it("keeps the upper left redder and the lower right bluer: much where superposed, hardly at the last term alone", () => {
    const whole = meanParts(0, 0, false);
    expect(whole.upperLeft[0]).toBeCloseTo(0.5625, 3);
    expect(whole.lowerRight[0]).toBeCloseTo(0.0625, 3);
    const alone = meanParts(0, 5, false);
    expect(alone.upperLeft[0] - alone.lowerRight[0]).toBeCloseTo(1 / 32, 3);
    const mean = meanParts(0, 5, true);
    expect(mean.upperLeft[0]).toBeGreaterThan(mean.lowerRight[0] + 0.2);
    expect(mean.lowerRight[2]).toBeGreaterThan(mean.upperLeft[2] + 0.2);
    expect(mean.lowerLeft[1]).toBeGreaterThan(mean.upperLeft[1] + 0.05);
  });

  it("has holes where the gasket has", () => {
    expect(pixel("gasket", 0, 5, false, [64, 64])[3]).toBe(0);
    expect(pixel("gasket", 1, 5, true, [64, 63])[3]).toBe(255);
  });
});
