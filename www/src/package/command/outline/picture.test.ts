import { zlibSync } from "fflate";
import { expect, test } from "vitest";
import { chunkBytes, joined, PNG_SIGNATURE } from "#workers/image/png";
import { orientationOf, pictureIn, smaller, upright } from "./picture";

const latin = (text: string) => [...text].map((letter) => letter.charCodeAt(0));

/** A PNG of these rows, as the specification has it; `kind` is 0 grey, 2 colours, 3 palette, 4 and 6 with alpha. */
function png(width: number, depth: number, kind: number, rows: number[][], more: [string, number[]][] = []) {
  const head = [0, 0, 0, width, 0, 0, 0, rows.length, depth, kind, 0, 0, 0];
  const packed = zlibSync(Uint8Array.from(rows.flatMap((row) => [0, ...row])));
  const chunks: [string, Iterable<number>][] = [["IHDR", head], ...more, ["IDAT", packed], ["IEND", []]];
  const parts = chunks.map(([type, data]) => chunkBytes({ type, data: Uint8Array.from(data) }));
  return joined([Uint8Array.from(PNG_SIGNATURE), ...parts]);
}

const pixels = async (file: Uint8Array) => [...((await pictureIn(file, "x"))?.pixels ?? [])];

test("all kinds of PNG are read, however few bits they have", async () => {
  // 9 pixels of a bit: each row ends in the midst of a byte.
  const bits = await pixels(
    png(9, 1, 0, [
      [0b10000000, 0b10000000],
      [0, 0],
    ]),
  );
  expect(bits.filter((_, i) => i % 4 === 0)).toEqual([255, 0, 0, 0, 0, 0, 0, 0, 255, ...Array(9).fill(0)]);
  expect(await pixels(png(3, 2, 0, [[0b00011011]]))).toEqual([
    0, 0, 0, 255, 85, 85, 85, 255, 170, 170, 170, 255,
  ]);
  expect(await pixels(png(1, 16, 2, [[255, 255, 128, 0, 0, 0]]))).toEqual([255, 128, 0, 255]);
  expect(await pixels(png(1, 8, 4, [[7, 9]]))).toEqual([7, 7, 7, 9]);
  expect(await pixels(png(1, 8, 6, [[1, 2, 3, 4]]))).toEqual([1, 2, 3, 4]);
  const table: [string, number[]][] = [
    ["PLTE", [10, 20, 30, 40, 50, 60]],
    ["tRNS", [255, 0]],
  ];
  expect(await pixels(png(2, 4, 3, [[0x01]], table))).toEqual([10, 20, 30, 255, 40, 50, 60, 0]);
  // One colour stands for what is clear.
  const clear: [string, number[]][] = [["tRNS", [0, 1, 0, 2, 0, 3]]];
  expect(await pixels(png(3, 8, 2, [[1, 2, 3, 1, 2, 4, 1, 2, 3]], clear))).toEqual([
    1, 2, 3, 0, 1, 2, 4, 255, 1, 2, 3, 0,
  ]);
});

test("what is no whole picture, or none that is read, is told", async () => {
  const file = png(1, 8, 6, [[1, 2, 3, 4]]);
  await expect(pictureIn(file.subarray(0, file.length - 12), "x")).rejects.toThrow(
    /x is damaged or ends too soon/,
  );
  const broken = file.slice();
  broken[45] = 0;
  await expect(pictureIn(broken, "x")).rejects.toThrow(/damaged/);
  await expect(pictureIn(png(1, 8, 6, [[1, 2, 3, 4]]).fill(0x7f, 16, 24), "x")).rejects.toThrow(/megapixels/);
  await expect(pictureIn(Uint8Array.from([...latin("GIF89a"), 1, 0, 1, 0]), "x")).rejects.toThrow(
    /save it as/,
  );
  await expect(pictureIn(Uint8Array.from(latin("%PDF-1.7")), "x")).rejects.toThrow(/x is a PDF/);
  expect(await pictureIn(Uint8Array.from(latin("x,y\n0,0")), "x")).toBeNull();
});

test("a photograph stands as it was taken, whichever way the camera was held", () => {
  const exif = (value: number, small: boolean) => {
    const word = (x: number) => (small ? [x & 255, x >> 8] : [x >> 8, x & 255]);
    const long = (x: number) => (small ? [...word(x), 0, 0] : [0, 0, ...word(x)]);
    const order = small ? [0x49, 0x49] : [0x4d, 0x4d];
    const entry = [...word(0x0112), ...word(3), ...long(1), ...word(value), 0, 0];
    const block = [...latin("Exif\0\0"), ...order, ...word(42), ...long(8), ...word(1), ...entry, ...long(0)];
    return Uint8Array.from([0xff, 0xd8, 0xff, 0xe1, 0, block.length + 2, ...block, 0xff, 0xda, 0, 2]);
  };
  expect([exif(6, true), exif(6, false), exif(9, true)].map(orientationOf)).toEqual([6, 6, 1]);
  expect(orientationOf(Uint8Array.from([0xff, 0xd8, 0xff, 0xe1, 0, 40, 0x45, 0x78]))).toBe(1);
  // a b c      Each number is where the row 0 and the column 0 of the file are, as Exif has it.
  // d e f
  const picture = {
    width: 3,
    height: 2,
    pixels: Uint8Array.from([..."abcdef"].flatMap((x) => [x.charCodeAt(0), 0, 0, 0])),
  };
  const seen = [1, 2, 3, 4, 5, 6, 7, 8].map((orientation) => {
    const { width, pixels } = upright(picture, orientation);
    const letters = String.fromCharCode(...pixels.filter((_, i) => i % 4 === 0));
    return letters.match(new RegExp(`.{${width}}`, "g"))?.join(" ");
  });
  expect(seen).toEqual([
    "abc def",
    "cba fed",
    "fed cba",
    "def abc",
    "ad be cf",
    "da eb fc",
    "fc eb da",
    "cf be ad",
  ]);
});

test("a large picture becomes the means of its blocks", () => {
  const pixels = Uint8Array.from({ length: 4 * 16 }, (_, i) => (i % 8 < 4 ? 0 : 100));
  const made = smaller({ width: 4, height: 4, pixels }, 4);
  expect([made.width, made.height, ...made.pixels]).toEqual([2, 2, ...Array(16).fill(50)]);
  expect(smaller({ width: 4, height: 4, pixels }, 16).pixels).toBe(pixels);
});
