import { expect, it } from "vitest";
import { looksOf } from "./holes";

const looks = (...rows: string[]) =>
  looksOf(
    [...rows.join("")].map((c) => c === "#"),
    rows[0]?.length ?? 0,
    rows.length,
  );

it("counts parts and holes", () => {
  expect(looks("........", "........")).toEqual({ parts: 0, holes: 0 });
  expect(looks("########", "#..##..#", "#..##..#", "########")).toEqual({ parts: 1, holes: 2 });
  expect(looks("##..####", "##..#..#", "....#..#", "....####")).toEqual({ parts: 2, holes: 1 });
});

it("lets the shape hold in a corner, and the ground not slip through one", () => {
  expect(looks("#...", ".#..", "..#.", "...#")).toEqual({ parts: 1, holes: 0 });
  expect(looks(".##.", "#..#", "#..#", ".##.")).toEqual({ parts: 1, holes: 1 });
});

it("takes a flaw for none, and what is open to the edge", () => {
  expect(looks("####", "#.##", "####", "####")).toEqual({ parts: 1, holes: 0 });
  expect(looks("####", "#...", "#...", "####")).toEqual({ parts: 1, holes: 0 });
});
