import { describe, expect, it } from "vitest";
import { type Certified, joined } from "./certify";

const nothing: Certified = {
  points: [],
  inputs: { from: [], to: [], options: {} },
  within: 1 / 600,
  done: 0,
  parts: 2,
  gap: 0,
  boxes: 0,
  joints: 0,
  worst: 0,
  holds: true,
  problem: null,
};
const part = { gap: 0.001, holds: true, boxes: 10, joints: 0, worst: 0.2, complete: true };

describe("joined", () => {
  it("keeps the weakest bound and where it is, in whatever order the parts come", () => {
    const wide = { ...part, gap: 0.02, holds: false, worst: 0.7 };
    for (const order of [
      [part, wide],
      [wide, part],
    ]) {
      const all = order.reduce(joined, nothing);
      expect(all).toMatchObject({ done: 2, gap: 0.02, worst: 0.7, boxes: 20, holds: false });
    }
  });

  it("tells of joints that hold all of it", () => {
    const held = { ...part, gap: 1e-15, boxes: 0, joints: 3 };
    expect([held, held].reduce(joined, nothing)).toMatchObject({ boxes: 0, joints: 3, gap: 1e-15 });
  });

  it("has no bound where one part has none", () => {
    const open = { ...part, gap: Number.POSITIVE_INFINITY, holds: false, worst: 0.4, complete: false };
    expect([open, part].reduce(joined, nothing)).toMatchObject({ gap: Number.POSITIVE_INFINITY, worst: 0.4 });
  });
});
