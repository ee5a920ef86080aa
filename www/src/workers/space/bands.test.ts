import { expect, test, vi } from "vitest";
import { bandsOf, pictureInBands, reliefInBands } from "./bands";
import type { PictureRequest, Rows } from "./picture";

/** Workers that paint each pixel with the number of its row, the first of them slowly. */
const asked = vi.hoisted(() => [] as { lane: number; rows: readonly [number, number] }[]);
vi.mock("./client", () => ({
  spaceTask: async (
    name: string,
    request: { width: number; factor?: number; rows: Rows },
    { lane }: { lane: number },
  ) => {
    const { width, factor = 1, rows } = request;
    asked.push({ lane, rows });
    for (let turn = 0; turn < (lane === 0 ? 10 : 1); turn++) await Promise.resolve();
    const [from, to] = rows;
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
