import { expect, test } from "vitest";
import { palette } from "#style/palette";
import { recolour } from "./recolour";

test("what is of the dark palette becomes the same of the light one, and nothing else changes", () => {
  const [, blue = ""] = palette("dark");
  expect(blue).toBe("#56b4e9");
  // One of its colours, half covered and rounded; ink; nothing.
  const pixels = new Uint8ClampedArray([0x57, 0xb3, 0xe9, 128, 20, 20, 20, 255, 0x56, 0xb4, 0xe9, 0]);
  recolour(pixels, palette("dark"), palette("light"));
  expect([...pixels]).toEqual([0x00, 0x72, 0xb2, 128, 20, 20, 20, 255, 0x56, 0xb4, 0xe9, 0]);
});
