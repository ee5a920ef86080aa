import { describe, expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { world } from "./coordinates";
import { cornersOf, dragged, GRIPS } from "./parallelogram";

const frame = { x0: -1, y0: 2, x1: 3, y1: 5 };
const map: MapRow = [0.5, -0.2, 0.3, 0.4, 1, -1];

describe("dragged", () => {
  it.each(GRIPS)("takes the grip %s to the pointer", (grip) => {
    const to = world(0.7, 4.1);
    const at = cornersOf(dragged(map, frame, grip, to), frame)[grip];
    expect(at.x).toBeCloseTo(to.x, 12);
    expect(at.y).toBeCloseTo(to.y, 12);
  });

  it.each(GRIPS.filter((grip) => grip !== "origin"))(
    "leaves the origin where it is when %s moves",
    (grip) => {
      const before = cornersOf(map, frame).origin;
      const after = cornersOf(dragged(map, frame, grip, world(0.7, 4.1)), frame).origin;
      expect(after.x).toBeCloseTo(before.x, 12);
      expect(after.y).toBeCloseTo(before.y, 12);
    },
  );

  it("turns and scales without shearing", () => {
    const [a, b, c, d] = dragged([0.5, 0, 0, 0.5, 0, 0], frame, "turn", world(0, 0));
    expect(a).toBeCloseTo(d, 12);
    expect(b).toBeCloseTo(-c, 12);
  });

  it("changes nothing where a drag would ask the impossible", () => {
    const flat = { x0: 1, y0: 1, x1: 1, y1: 1 };
    for (const grip of ["x", "y", "turn"] as const) {
      expect(dragged(map, flat, grip, world(3, 3))).toEqual(map);
    }
  });
});
