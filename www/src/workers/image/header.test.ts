import { describe, expect, test } from "vitest";
import { readHeader } from "./header";

const ascii = (text: string) => [...text].map((c) => c.charCodeAt(0));
const big = (n: number, bytes: number) =>
  Array.from({ length: bytes }, (_, i) => (n >>> (8 * (bytes - 1 - i))) & 255);
const little = (n: number, bytes: number) => big(n, bytes).reverse();
const read = (...parts: number[][]) => readHeader(new Uint8Array(parts.flat()));

const PNG = [[0x89], ascii("PNG\r\n\x1a\n"), big(13, 4), ascii("IHDR")];

describe("sizes", () => {
  test("of PNG files", () => {
    const header = read(...PNG, big(10_000, 4), big(12_345, 4), [8, 6, 0, 0, 0]);
    expect(header).toEqual({ kind: "png", size: { width: 10_000, height: 12_345 } });
  });

  test("of JPEG files, behind other segments and fill bytes", () => {
    const app = [[0xff, 0xe1], big(2 + 300, 2), new Array<number>(300).fill(0xff)];
    for (const marker of [0xc0, 0xc1, 0xc2, 0xcf]) {
      const frame = [[0xff, 0xff, marker], big(17, 2), [8], big(400, 2), big(640, 2), [3]];
      const tables = [[0xff, 0xc4], big(5, 2), [1, 2, 3]];
      const header = read([0xff, 0xd8], ...app, ...tables, ...frame);
      expect(header).toEqual({ kind: "jpeg", size: { width: 640, height: 400 } });
    }
  });

  test("of WebP files of all three kinds", () => {
    const riff = (chunk: string, rest: number[]) =>
      read(ascii("RIFF"), little(99, 4), ascii("WEBP"), ascii(chunk), little(50, 4), rest);
    const extended = riff("VP8X", [0, 0, 0, 0, ...little(4999, 3), ...little(2999, 3)]);
    expect(extended).toEqual({ kind: "webp", size: { width: 5000, height: 3000 } });
    const lossless = riff("VP8L", [0x2f, ...little(((700 - 1) << 14) | (900 - 1), 4)]);
    expect(lossless).toEqual({ kind: "webp", size: { width: 900, height: 700 } });
    const lossy = riff("VP8 ", [0, 0, 0, 0x9d, 0x01, 0x2a, ...little(800, 2), ...little(600, 2)]);
    expect(lossy).toEqual({ kind: "webp", size: { width: 800, height: 600 } });
  });

  test("of GIF files, and the largest of an AVIF", () => {
    expect(read(ascii("GIF89a"), little(320, 2), little(200, 2))).toEqual({
      kind: "gif",
      size: { width: 320, height: 200 },
    });
    const ispe = (w: number, h: number) => [
      ...big(20, 4),
      ...ascii("ispe"),
      0,
      0,
      0,
      0,
      ...big(w, 4),
      ...big(h, 4),
    ];
    const avif = read(
      big(32, 4),
      ascii("ftypavif"),
      big(0, 4),
      ascii("avifmif1miaf"),
      ispe(160, 120),
      ispe(8000, 6000),
    );
    expect(avif).toEqual({ kind: "avif", size: { width: 8000, height: 6000 } });
  });
});

describe("what is no picture that can be bent", () => {
  test("drawings are known whatever stands before them", () => {
    for (const text of [
      '<svg xmlns="x">',
      '<?xml version="1.0"?>\n<!-- a -->\n<svg width="1">',
      "\xef\xbb\xbf  <!DOCTYPE svg PUBLIC><svg>",
    ]) {
      expect(read(ascii(text)).kind).toBe("svg");
    }
    expect(read(ascii("<html><body><p>svg</p>")).kind).toBe("unknown");
  });

  test("text, nothing, and headers that end too soon", () => {
    expect(read(ascii("hello")).kind).toBe("unknown");
    expect(read([]).kind).toBe("unknown");
    const whole = [
      [...PNG.flat(), ...big(10, 4), ...big(10, 4)],
      [0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0, 9, 0, 9],
      [...ascii("RIFF"), 0, 0, 0, 0, ...ascii("WEBPVP8X"), ...new Array<number>(14).fill(1)],
      [...ascii("RIFF"), 0, 0, 0, 0, ...ascii("WEBPVP8L"), ...new Array<number>(14).fill(1)],
      [...ascii("GIF89a"), 1, 0, 1, 0],
      [...ascii("BM"), 1, 1, 1, 1, 0, 0, 0, 0, ...new Array<number>(32).fill(1)],
    ];
    for (const bytes of whole) {
      expect(read(bytes).size).toBeDefined();
      for (let cut = 0; cut < bytes.length; cut++) expect(() => read(bytes.slice(0, cut))).not.toThrow();
    }
  });

  test("sizes of nothing are none", () => {
    expect(read(...PNG, big(0, 4), big(5, 4)).size).toBeUndefined();
    expect(
      read([0xff, 0xd8, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff]).size,
    ).toBeUndefined();
  });
});
