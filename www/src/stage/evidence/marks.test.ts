import { describe, expect, it } from "vitest";
import type { Certificate } from "#wasm/api";
import { hullsOf } from "./marks";

const certificate: Certificate = {
  maps: [
    [0.25, 0, 0, 0.25, 0, 0],
    [0.25, 0, 0, 0.25, 3, 0],
  ],
  polygon: [
    [-1, -1],
    [5, -1],
    [5, 1],
    [-1, 1],
  ],
  letters: 1,
  side: [0, 1],
  pairs: [
    { u: [0], v: [1, 0], normal: [1, 0] },
    { u: [0], v: [1, 1], normal: [1, 0] },
  ],
};

describe("hullsOf", () => {
  it("draws each piece once, the first letter outermost", () => {
    const hulls = hullsOf(certificate);
    expect(hulls.map(({ side }) => side)).toEqual([0, 1, 1]);
    expect(hulls[0]?.corners[1]).toEqual([1.25, -0.25]);
    // w1 (w0 (5, -1)) = w1 (1.25, -0.25).
    expect(hulls[1]?.corners[1]).toEqual([3.3125, -0.0625]);
  });

  it("leaves out the whole", () => {
    expect(hullsOf({ ...certificate, pairs: [{ u: [], v: [1], normal: [1, 0] }] })).toHaveLength(1);
  });
});
