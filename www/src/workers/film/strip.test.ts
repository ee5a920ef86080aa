import { expect, it } from "vitest";
import { stripView } from "./strip";

it("shows rows of a picture where the whole has them", () => {
  const view = { x: 3, y: 10, scale: 20 };
  // The middle of rows 0 to 39 of 240 is 100 rows above the middle.
  expect(stripView(view, 240, { top: 0, count: 40 })).toEqual({ x: 3, y: 15, scale: 20 });
  expect(stripView(view, 240, { top: 200, count: 40 })).toEqual({ x: 3, y: 5, scale: 20 });
  expect(stripView(view, 240, { top: 0, count: 240 })).toEqual(view);
});
