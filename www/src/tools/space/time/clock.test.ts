import { expect, it } from "vitest";
import { advance } from "./clock";

it("goes round where it loops, over the end in one step too", () => {
  expect(advance(5.5, 1, { seconds: 6, loop: "round" })).toMatchObject({ at: 0.5, ended: false });
  expect(advance(0, 13, { seconds: 6, loop: "round" })).toMatchObject({ at: 1, ended: false });
});

it("turns at both ends where it goes to and fro", () => {
  const line = { seconds: 6, loop: "pingpong" } as const;
  expect(advance(5.5, 0.25, line, 1)).toEqual({ at: 5.75, way: 1, ended: false });
  expect(advance(5.5, 1, line, 1)).toEqual({ at: 5.5, way: -1, ended: false });
  expect(advance(6, 0.5, line, -1)).toEqual({ at: 5.5, way: -1, ended: false });
  expect(advance(0.5, 1, line, -1)).toEqual({ at: 0.5, way: 1, ended: false });
  expect(advance(1, 25, line, 1)).toEqual({ at: 2, way: 1, ended: false });
});

it("ends at the end where it goes once", () => {
  expect(advance(5.5, 0.25, { seconds: 6, loop: "once" })).toMatchObject({ at: 5.75, ended: false });
  expect(advance(5.5, 1, { seconds: 6, loop: "once" })).toMatchObject({ at: 6, ended: true });
});
