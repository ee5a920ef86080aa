import { describe, expect, it } from "vitest";
import { STATE } from "#geometry/states";
import { EPSILON, LocusFill, SIZE, STRIDES, shareOf } from "./locus-fill";

/** Samples of a row range, all the same. */
function tile(r0: number, r1: number, stride: number, state: number, gap: number) {
  const count = Math.ceil((r1 - r0) / stride) * Math.ceil(SIZE / stride);
  return { state: new Uint8Array(count).fill(state), gap: new Float32Array(count).fill(gap) };
}

describe("a locus on its way", () => {
  it("has both ends of the morph among the samples of every stride", () => {
    for (const stride of STRIDES) {
      expect((SIZE - 1) % stride).toBe(0);
      expect(((SIZE - 1) / 3) % stride).toBe(0);
    }
  });

  it("is known everywhere after the coarsest stride", () => {
    const fill = new LocusFill();
    fill.put(0, SIZE, 8, tile(0, SIZE, 8, STATE.connected, 0));
    expect(fill.locus.state.every((s) => s === STATE.connected)).toBe(true);
  });

  it("lets a finer sample speak for its own surroundings alone", () => {
    const fill = new LocusFill();
    fill.put(0, SIZE, 8, tile(0, SIZE, 8, STATE.connected, 0));
    const fine = tile(8, 9, 2, STATE.disconnected, 0.5);
    fill.put(8, 9, 2, fine);
    const { state, gap } = fill.locus;
    expect(state[8 * SIZE + 60]).toBe(STATE.disconnected);
    expect(gap[7 * SIZE + 60]).toBe(0.5);
    expect(state[9 * SIZE + 60]).toBe(STATE.connected);
    expect(state[6 * SIZE + 60]).toBe(STATE.connected);
  });

  it("tells pieces that no picture shows to be apart from those that are seen to be", () => {
    const fill = new LocusFill();
    fill.put(0, 1, 1, tile(0, 1, 1, STATE.disconnected, EPSILON / 2));
    expect(fill.locus.state[5]).toBe(STATE.hidden);
    expect(fill.locus.state[SIZE + 5]).toBe(STATE.pending);
  });

  it("keeps to the rows that it was given", () => {
    const fill = new LocusFill();
    const { state, gap } = tile(40, 44, 1, STATE.disconnected, 0.25);
    state[SIZE] = STATE.none;
    fill.put(40, 44, 1, { state, gap });
    expect(fill.locus.state[41 * SIZE]).toBe(STATE.none);
    expect(fill.locus.state[44 * SIZE]).toBe(STATE.pending);
  });
});

describe("how far it is", () => {
  it("runs from 0 to 1 without going back", () => {
    const shares = STRIDES.flatMap((_, stage) => [0, 40, SIZE].map((r) => shareOf(stage, r)));
    expect(shares[0]).toBe(0);
    expect(shares.at(-1)).toBe(1);
    expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  });
});
