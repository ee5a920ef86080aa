import { expect, it } from "vitest";
import { detailFor } from "./large";

it("samples the map more finely where it is larger, and never without end", () => {
  expect([0, 200, 307, 340, 350, 614, 680, 700, 1228, 1e6].map(detailFor)).toEqual([
    1, 1, 1, 1, 2, 2, 2, 4, 4, 4,
  ]);
});
