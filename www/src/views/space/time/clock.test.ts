import { expect, it } from "vitest";
import { advance } from "./clock";

it("goes round where it loops, over the end in one step too", () => {
  expect(advance(5.5, 1, { seconds: 6, loop: true })).toEqual({ at: 0.5, ended: false });
  expect(advance(0, 13, { seconds: 6, loop: true })).toEqual({ at: 1, ended: false });
});

it("ends at the end where it does not", () => {
  expect(advance(5.5, 0.25, { seconds: 6, loop: false })).toEqual({ at: 5.75, ended: false });
  expect(advance(5.5, 1, { seconds: 6, loop: false })).toEqual({ at: 6, ended: true });
});
