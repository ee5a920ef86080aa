import { expect, it } from "vitest";
import { chunksOf, joined } from "../../image/png";
import { PngFile } from "./png-file";

/** The pixels of a file as another reader finds them: unpacked, and its filters undone as the specification says. */
async function read(file: Uint8Array) {
  const chunks = chunksOf(file);
  const head = chunks[0]?.data ?? new Uint8Array();
  const view = new DataView(head.buffer, head.byteOffset);
  const [width, height, channels] = [view.getUint32(0), view.getUint32(4), head[9] === 6 ? 4 : 3];
  const data = joined(chunks.filter(({ type }) => type === "IDAT").map((chunk) => chunk.data));
  const stream = new Blob([data]).stream().pipeThrough(new DecompressionStream("deflate"));
  const raw = new Uint8Array(await new Response(stream).arrayBuffer());
  const rows: number[][] = [];
  for (let y = 0; y < height; y++) {
    const line = raw.subarray(y * (width * channels + 1), (y + 1) * (width * channels + 1));
    const row: number[] = [];
    for (let i = 0; i < width * channels; i++) {
      const left = row[i - channels] ?? 0;
      const up = rows[y - 1]?.[i] ?? 0;
      const guess = [0, left, up][line[0] ?? 0];
      if (guess === undefined) throw new Error("another filter");
      row.push(((line[i + 1] ?? 0) + guess) & 255);
    }
    rows.push(row);
  }
  const types = chunks.map(({ type }) => type);
  const text = chunks.find(({ type }) => type === "iTXt")?.data;
  return { width, height, pixels: rows.flat(), types, text: text && new TextDecoder().decode(text) };
}

const SIDE = 40;
const pixels = Uint8ClampedArray.from({ length: 4 * SIDE * SIDE }, (_, i) => {
  const [x, y] = [(i >> 2) % SIDE, Math.floor((i >> 2) / SIDE)];
  return i % 4 === 3 ? (x > 20 ? 255 : 128) : x < 13 ? 7 * y : y < 9 ? 5 * x : (x * y * (i % 4)) & 255;
});

it("holds every pixel, in however many parts its rows come, and the link", async () => {
  for (const parts of [[SIDE], [1, 39], [13, 13, 14]]) {
    const file = new PngFile({
      width: SIDE,
      height: SIDE,
      opaque: false,
      link: "https://frond.example/#a=fern",
    });
    let at = 0;
    for (const rows of parts) {
      await file.add(pixels.subarray(4 * SIDE * at, 4 * SIDE * (at + rows)));
      at += rows;
    }
    const found = await read(await file.finish());
    expect([found.width, found.height]).toEqual([SIDE, SIDE]);
    expect(found.pixels).toEqual([...pixels]);
    expect(found.types[1]).toBe("iTXt");
    expect(found.text).toBe("Frond link\0\0\0\0\0https://frond.example/#a=fern");
  }
});

it("has three bytes a pixel where nothing is clear", async () => {
  const file = new PngFile({ width: SIDE, height: SIDE, opaque: true, link: null });
  await file.add(pixels);
  const found = await read(await file.finish());
  expect(found.pixels).toEqual([...pixels].filter((_, i) => i % 4 !== 3));
  expect(found.types).toEqual(["IHDR", "IDAT", "IEND"]);
});

it("is no file before it is whole, and takes no rows that are none of its own", async () => {
  const file = new PngFile({ width: SIDE, height: SIDE, opaque: true, link: null });
  await expect(file.add(pixels.subarray(0, 10))).rejects.toThrow("no rows");
  await file.add(pixels.subarray(0, 4 * SIDE * 39));
  await expect(file.finish()).rejects.toThrow("not whole");
  await expect(file.add(pixels)).rejects.toThrow("no rows");
});
