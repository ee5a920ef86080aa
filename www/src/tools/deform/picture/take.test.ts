import { expect, test } from "vitest";
import { readHeader } from "#workers/image/header";
import { kept, refusal as refusalOf, shortName } from "./take";

const refusal = (name: string, head: Uint8Array) => refusalOf(name, readHeader(head));

function png(width: number, height: number): Uint8Array {
  const bytes = new Uint8Array(33);
  bytes.set([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52]);
  new DataView(bytes.buffer).setUint32(16, width);
  new DataView(bytes.buffer).setUint32(20, height);
  return bytes;
}

test("a picture of 100 megapixels is refused with the limit, one of 64 is not", () => {
  expect(refusal("a.png", png(10_000, 10_000))).toMatch(
    /10,000 × 10,000 .* 100 megapixels\. The limit is 64 /,
  );
  expect(refusal("a.png", png(8000, 8000))).toBeNull();
  expect(refusal("a.png", png(8000, 8001))).not.toBeNull();
  expect(refusal("a.png", png(0xffffffff, 0xffffffff))).toMatch(/megapixels/);
});

test("what is no picture is told from one that ends too soon", () => {
  const text = (words: string) => new TextEncoder().encode(words);
  expect(refusal("a.svg", text("<svg/>"))).toMatch(/Save it as PNG/);
  expect(refusal("notes.png", text("milk, bread"))).toMatch(/PNG, JPEG, WebP/);
  // A photograph of a phone, whatever it is called.
  expect(refusal("leaf.jpg", text("\0\0\0\x18ftypheic"))).toMatch(
    /^“leaf.jpg” is a HEIC picture. Save it as JPEG/,
  );
  expect(refusal("a.png", png(3, 3).slice(0, 20))).toMatch(/damaged or incomplete/);
  expect(refusal("nothing.png", new Uint8Array())).not.toBeNull();
});

test("long sides are shortened, and none vanishes", () => {
  expect(kept(1000, 700)).toEqual({ width: 1000, height: 700 });
  expect(kept(6000, 4000)).toEqual({ width: 2048, height: 1365 });
  expect(kept(30_000, 1)).toEqual({ width: 2048, height: 1 });
});

test("names fit a line", () => {
  expect(shortName(" ")).toBe("Picture");
  expect(shortName("beach.jpg")).toBe("beach.jpg");
  expect(shortName(`${"x".repeat(300)}.jpg`).length).toBeLessThanOrEqual(40);
});
