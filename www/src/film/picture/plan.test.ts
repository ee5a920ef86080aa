import { expect, it } from "vitest";
import { type PicturePlan, pictureProblem } from "./plan";

const plan: PicturePlan = { width: 8192, height: 8192, ground: null, clear: true, link: true, smooth: false };

it("is as large as can be drawn: in strips, or at once", () => {
  expect(pictureProblem(plan, true)).toBeNull();
  expect(pictureProblem(plan, false)).toContain("at most 4096 × 4096");
  expect(pictureProblem({ ...plan, width: 4096, height: 4096 }, false)).toBeNull();
  for (const width of [0, 15, 8193, 1.5, Number.NaN, Number.POSITIVE_INFINITY]) {
    expect(pictureProblem({ ...plan, width }, true)).toContain("16 to 8192");
  }
});
