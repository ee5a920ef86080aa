import { expect, it } from "vitest";
import { framed, frameOfSize } from "../work/source";
import { cropOf } from "./photograph";

it("cuts a picture around a leaf, and knows where that lies in the plane", () => {
  // A leaf over the pixels 100 to 300 across and 50 to 150 down, of a picture of 400 by 200.
  const leaf = framed(Float64Array.of(100, 50, 300, 150), frameOfSize(400, 200));
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = leaf;
  const crop = cropOf({ x0, y0, x1, y1 }, 400, 200);
  expect(crop).toMatchObject({ left: 92, top: 42, across: 216, down: 116 });
  const corners = framed(Float64Array.of(92, 200 - 158, 308, 200 - 42), frameOfSize(400, 200));
  crop.box.forEach((side, i) => {
    expect(side).toBeCloseTo(corners[i] ?? Number.NaN, 12);
  });
});

it("stays within the picture", () => {
  const crop = cropOf({ x0: -1, y0: -0.5, x1: 1, y1: 0.5 }, 400, 200);
  expect(crop).toMatchObject({ left: 0, top: 0, across: 400, down: 200 });
  expect(crop.box).toEqual([-1, -0.5, 1, 0.5]);
});
