import { expect, it } from "vitest";
import { chunkBytes, chunksOf } from "../../image/png";
import { apngBytes } from "./apng";

const HEAD = Uint8Array.of(0, 0, 0, 2, 0, 0, 0, 1, 8, 6, 0, 0, 0);

it("is a PNG whose frames follow each other, each for its time, for ever", () => {
  const frames = [
    { data: [Uint8Array.of(1, 2)], count: 1 },
    { data: [Uint8Array.of(3), Uint8Array.of(4, 5)], count: 2 },
  ];
  const chunks = chunksOf(apngBytes(HEAD, frames, { width: 2, height: 1, fps: 30 }));
  expect(chunks.map(({ type }) => type)).toEqual([
    "IHDR",
    "acTL",
    "fcTL",
    "IDAT",
    "fcTL",
    "fdAT",
    "fdAT",
    "IEND",
  ]);
  const of = (type: string) => chunks.filter((chunk) => chunk.type === type).map(({ data }) => data);
  expect([...(of("acTL")[0] ?? [])]).toEqual([0, 0, 0, 2, 0, 0, 0, 0]);
  // What belongs to a frame is numbered through.
  const numbered = chunks.filter(({ type }) => type === "fcTL" || type === "fdAT");
  expect(numbered.map(({ data }) => data[3])).toEqual([0, 1, 2, 3]);
  const delays = of("fcTL").map((data) => 256 * (data[20] ?? 0) + (data[21] ?? 0));
  expect(delays).toEqual([33, 67]);
  expect(of("fdAT").map((data) => [...data.subarray(4)])).toEqual([[3], [4, 5]]);
});

it("has chunks that are checked as others check them", () => {
  // The last chunk of every PNG.
  const end = [0, 0, 0, 0, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82];
  expect([...chunkBytes({ type: "IEND", data: new Uint8Array() })]).toEqual(end);
});

it("reads no further than a file goes", () => {
  const whole = apngBytes(HEAD, [{ data: [Uint8Array.of(9)], count: 1 }], { width: 2, height: 1, fps: 10 });
  for (let cut = 0; cut < whole.length; cut++) {
    const read = chunksOf(whole.subarray(0, cut));
    expect(read.length).toBeLessThan(6);
    expect(read.some(({ type }) => type === "IEND")).toBe(false);
  }
  expect(chunksOf(Uint8Array.of(1, 2, 3))).toEqual([]);
});
