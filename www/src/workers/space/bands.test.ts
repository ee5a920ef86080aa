import { expect, test, vi } from "vitest";
import { bandsOf, lampInBands, litInBands, pictureInBands, reliefInBands } from "./bands";
import type { PictureRequest, Rows } from "./picture";

/** Workers that paint each pixel with the number of its row, the first of them slowly. */
const asked = vi.hoisted(() => [] as { lane: number; rows: readonly [number, number] }[]);
const given = vi.hoisted(() => [] as { top: number; rows: readonly [number, number]; count: number }[]);
vi.mock("./client", () => ({
  spaceTask: async (
    name: string,
    request: {
      width: number;
      factor?: number;
      rows: Rows;
      top?: number;
      depth?: Float32Array;
      light?: unknown;
    },
    { lane }: { lane: number },
  ) => {
    const { width, factor = 1, rows } = request;
    asked.push({ lane, rows });
    for (let turn = 0; turn < (lane === 0 ? 10 : 1); turn++) await Promise.resolve();
    const [from, to] = rows;
    // The lamp sees as many columns as its light says here.
    if (name === "lamp")
      return Float32Array.from({ length: (to - from) * 7 }, (_, i) => Math.floor(from + i / 7));
    if (name === "lit") {
      // What it was given of the row, and how many rows it was given around.
      const { top = 0, depth = new Float32Array() } = request;
      given.push({ top, rows, count: depth.length / (width * factor) });
      const at = (row: number) => depth[(row * factor - top) * width * factor] ?? -1;
      return Uint8ClampedArray.from({ length: ((to - from) / factor) * width * 4 }, (_, i) =>
        at(from / factor + Math.floor(i / (width * 4))),
      );
    }
    const codes = Uint32Array.from({ length: (to - from) * width * factor }, (_, i) =>
      Math.floor(from + i / (width * factor)),
    );
    if (name === "relief") return { depth: Float32Array.from(codes), codes, empty: false };
    const data = Uint8ClampedArray.from({ length: ((to - from) / factor) * width * 4 }, (_, i) =>
      Math.floor(from / factor + i / (width * 4)),
    );
    return { data, codes };
  },
}));

vi.stubGlobal("navigator", { hardwareConcurrency: 8 });
vi.stubGlobal(
  "ImageData",
  class {
    readonly data: Uint8ClampedArray;
    constructor(width: number, height: number) {
      this.data = new Uint8ClampedArray(4 * width * height);
    }
  },
);

test("rows of all workers come together in their places, and who is done first takes more", async () => {
  const signal = new AbortController().signal;
  const request = { width: 3, height: 41, factor: 2 } as PictureRequest;
  const { image, codes } = await pictureInBands(request, { reach: 1, codes: true, atRest: true, signal });
  expect([...image.data]).toEqual(Array.from({ length: 41 * 12 }, (_, i) => Math.floor(i / 12)));
  expect([...(codes ?? [])]).toEqual(Array.from({ length: 82 * 6 }, (_, i) => Math.floor(i / 6)));
  const by = (lane: number) => asked.filter((one) => one.lane === lane).length;
  expect(by(0)).toBeLessThan(by(4));
  const relief = await reliefInBands({ objects: [], view: {} as never, width: 5, height: 7 }, { signal });
  expect([...relief.depth]).toEqual(Array.from({ length: 35 }, (_, i) => Math.floor(i / 5)));
  asked.length = 0;
  await pictureInBands(request, { reach: 1, atRest: false, signal });
  expect(asked.map(({ lane }) => lane)).toEqual([0, 4]);
});

test("what was carved is lit in bands that have as many rows around as light hangs on", async () => {
  const signal = new AbortController().signal;
  const [width, height, factor] = [3, 40, 2] as const;
  const request = { width, height, factor, light: {} } as PictureRequest;
  const count = width * height * factor * factor;
  const depth = Float32Array.from({ length: count }, (_, i) => Math.floor(i / (width * factor)));
  const relief = { width: 6, height: 80, depth, codes: new Uint32Array(count), empty: false };
  const lamp = await lampInBands({ ...request, objects: [], view: {} as never }, 7, { signal });
  expect([...lamp]).toEqual(Array.from({ length: 49 }, (_, i) => Math.floor(i / 7)));
  const image = await litInBands(request, relief, { lamp, reach: 1, around: 5, signal });
  expect([...image.data]).toEqual(Array.from({ length: 40 * 12 }, (_, i) => 2 * Math.floor(i / 12)));
  for (const { top, rows, count } of given) {
    expect(top).toBe(Math.max(0, rows[0] - 5));
    expect(top + count).toBe(Math.min(80, rows[1] + 5));
  }
});

test("bands are all rows, once, whole pixels, and about alike", () => {
  for (const [height, factor, count] of [
    [600, 1, 2],
    [601, 2, 2],
    [7, 2, 3],
    [1, 2, 2],
  ] as const) {
    const bands = bandsOf(height, factor, count);
    expect(bands.length).toBe(Math.min(count, height));
    expect(bands[0]?.[0]).toBe(0);
    expect(bands.at(-1)?.[1]).toBe(height * factor);
    for (const [i, [from, to]] of bands.entries()) {
      expect(to - from).toBeGreaterThan(0);
      expect((to - from) % factor).toBe(0);
      expect(Math.abs((to - from) / factor - height / bands.length)).toBeLessThanOrEqual(1);
      if (i > 0) expect(from).toBe(bands[i - 1]?.[1]);
    }
  }
});
