import { expect, it } from "vitest";
import { halved } from "./halved";

it("is the mean of four pixels, each in its place", () => {
  const grey = (value: number) => [value, value + 1, value + 2, 255];
  const rows = [10, 20, 100, 100, 30, 40, 100, 100].flatMap(grey);
  expect([...halved(Uint8ClampedArray.from(rows), 4, 2)]).toEqual([...grey(25), ...grey(100)]);
  const tall = [10, 20, 30, 40, 50, 60, 70, 80].flatMap(grey);
  expect([...halved(Uint8ClampedArray.from(tall), 2, 4)]).toEqual([...grey(25), ...grey(65)]);
});

it("does not take colour from what is clear", () => {
  const four = Uint8ClampedArray.of(200, 100, 50, 255, 0, 0, 0, 0, 9, 9, 9, 0, 200, 100, 50, 255);
  expect([...halved(four, 2, 2)]).toEqual([200, 100, 50, 128]);
  expect([...halved(new Uint8ClampedArray(16), 2, 2)]).toEqual([0, 0, 0, 0]);
});
