import { zlibSync } from "fflate";
import { expect, test } from "vitest";
import { type PngSettings, pngOf, RowFilter } from "#workers/film/format/png-rows";
import { frameFile, isSame } from "./frame-file";

test("frames are numbered before the ending, wherever they lie", () => {
  expect(frameFile("a.b/x.PNG", 0)).toBe("a.b/x-0001.PNG");
  expect(frameFile("x", 11_999)).toBe("x-12000");
});

test("a frame that is there is the one that is wanted, or it is not", () => {
  const settings: PngSettings = { width: 2, height: 1, opaque: true, link: "#a=fern", ground: "#ff8000" };
  const rows = new RowFilter(settings).filtered(Uint8ClampedArray.from([1, 2, 3, 4, 5, 6, 7, 8]));
  const file = pngOf(settings, zlibSync(rows));
  expect(isSame(file, settings)).toBe(true);
  for (const other of [
    { width: 1 },
    { height: 2 },
    { opaque: false },
    { link: "#a=tree" },
    { ground: "#ff8001" },
  ])
    expect(isSame(file, { ...settings, ...other })).toBe(false);
  for (let at = 0; at < file.length; at++) {
    const damaged = file.slice();
    damaged[at] = (damaged[at] ?? 0) ^ 1;
    expect(isSame(damaged, settings), `byte ${at}`).toBe(false);
    expect(isSame(file.subarray(0, at), settings)).toBe(false);
  }
  expect(isSame(Uint8Array.from([...file, 0]), settings)).toBe(false);
});
