import { describe, expect, it } from "vitest";
import { channels, layOn } from "../opaque";
import { changesSince, dithered, gifDelay, gifSink } from "./gif";

describe("a GIF", () => {
  it("keeps time: delays are whole hundredths and add up", () => {
    for (const fps of [10, 12, 24, 30, 50]) {
      const delays = Array.from({ length: 600 }, (_, i) => gifDelay(i, fps));
      expect(Math.abs(delays.reduce((a, b) => a + b, 0) - 60_000 / fps)).toBeLessThanOrEqual(1);
      // Browsers do not believe in less.
      expect(Math.min(...delays)).toBeGreaterThanOrEqual(2);
    }
  });

  it("says only what changes", () => {
    expect([...changesSince(Uint8Array.of(1, 2, 3), Uint8Array.of(1, 5, 3))]).toEqual([255, 5, 255]);
  });

  it("is one, with all its frames, for ever", async () => {
    const frame = (red: number) =>
      Uint8ClampedArray.from([red, 0, 0, 255, 9, 9, 9, 255, 0, 0, 200, 255, 9, 9, 9, 255]);
    const samples = new Uint8ClampedArray([...frame(250), ...frame(120)]);
    const sink = await gifSink({ width: 2, height: 2, fps: 30, ground: "#090909", dither: false, samples });
    for (const red of [250, 120, 250]) await sink.add(frame(red));
    const bytes = await sink.finish();
    const text = String.fromCharCode(...bytes);
    expect(text.slice(0, 6)).toBe("GIF89a");
    expect([bytes[6], bytes[8]]).toEqual([2, 2]);
    // The ground is the first colour, exactly.
    expect([...bytes.slice(13, 16)]).toEqual([9, 9, 9]);
    expect(text).toContain("NETSCAPE2.0");
    const controls = controlsOf(bytes);
    expect(controls.map(({ delay }) => delay)).toEqual([3, 4, 3]);
    // Drawn over what is there; from the second on, what stays is left out.
    expect(controls.map(({ flags }) => flags)).toEqual([4, 5, 5]);
    expect(bytes.at(-1)).toBe(0x3b);
  });

  it("has holes where nothing is, and each frame is drawn on an empty one", async () => {
    const frame = Uint8ClampedArray.from([250, 0, 0, 255, 9, 9, 9, 0]);
    const sink = await gifSink({ width: 2, height: 1, fps: 10, ground: null, dither: true, samples: frame });
    for (let i = 0; i < 2; i++) await sink.add(frame.slice());
    // Restore to what was before the first; colour 255 is clear.
    expect(controlsOf(await sink.finish()).map(({ flags }) => flags)).toEqual([9, 9]);
  });

  it("mixes a colour from dots that are right on the whole, and leaves the ground alone", () => {
    const grey = new Uint8ClampedArray(4 * 64).fill(100);
    grey.set([7, 8, 9, 255]);
    const made = dithered(grey, 8, [7, 8, 9]);
    expect([...made.subarray(0, 4)]).toEqual([7, 8, 9, 255]);
    const reds = Array.from({ length: 63 }, (_, i) => made[4 * (i + 1)] ?? 0);
    expect(new Set(reds).size).toBeGreaterThan(15);
    expect(Math.abs(reds.reduce((a, b) => a + b, 0) / 63 - 100)).toBeLessThan(0.5);
    // No two neighbours in a row are alike: that would be a stripe.
    for (let i = 1; i < 7; i++) expect(made[4 * i]).not.toBe(made[4 * (i + 1)]);
  });
});

/** What is said before each frame. */
function controlsOf(bytes: Uint8Array): { flags: number; delay: number }[] {
  const found: { flags: number; delay: number }[] = [];
  for (let i = 0; i < bytes.length - 7; i++) {
    if (bytes[i] !== 0x21 || bytes[i + 1] !== 0xf9 || bytes[i + 2] !== 4 || bytes[i + 7] !== 0) continue;
    found.push({ flags: bytes[i + 3] ?? 0, delay: (bytes[i + 4] ?? 0) + 256 * (bytes[i + 5] ?? 0) });
  }
  return found;
}

describe("a picture on its ground", () => {
  it("is opaque", () => {
    const pixels = Uint8ClampedArray.from([200, 100, 0, 255, 200, 100, 0, 0, 200, 100, 0, 51]);
    layOn(pixels, "#0a141e");
    expect([...pixels]).toEqual([200, 100, 0, 255, 10, 20, 30, 255, 48, 36, 24, 255]);
    expect(channels("#ff8001")).toEqual([255, 128, 1]);
  });
});
