import { describe, expect, test } from "vitest";
import { isWhole } from "./whole";

const ascii = (text: string) => [...text].map((c) => c.charCodeAt(0));
/** A thumbnail with an end of its own stands in the first segment. */
const JPEG = [
  0xff, 0xd8, 0xff, 0xe1, 0, 6, 0xff, 0xd8, 0xff, 0xd9, 0xff, 0xda, 0, 4, 1, 2, 9, 0xff, 0, 8, 7, 0xff, 0xd9,
];
const chunk = (name: string, length: number) => [
  ...[0, 0, 0, length],
  ...ascii(name),
  ...new Array<number>(length + 4).fill(7),
];
const PNG = [
  0x89,
  ...ascii("PNG\r\n\x1a\n"),
  ...chunk("IHDR", 13),
  ...chunk("IDAT", 40),
  ...chunk("IEND", 0),
];
const WEBP = [...ascii("RIFF"), 12, 0, 0, 0, ...ascii("WEBPVP8 "), 0, 0, 0, 0];

describe("the end of a picture", () => {
  test.each([
    ["jpeg", JPEG, 0],
    ["png", PNG, 8],
    ["webp", WEBP, 0],
  ] as const)("of %s is missed wherever it is cut", (kind, whole, spare) => {
    expect(isWhole(kind, new Uint8Array(whole))).toBe(true);
    expect(isWhole(kind, new Uint8Array([...whole, ...ascii("a film behind it")]))).toBe(true);
    for (let cut = 0; cut < whole.length - spare; cut++) {
      expect(isWhole(kind, new Uint8Array(whole.slice(0, cut)))).toBe(cut >= whole.length - spare);
    }
  });

  test("of others is left to the decoder", () => {
    expect(isWhole("gif", new Uint8Array(3))).toBe(true);
  });
});
