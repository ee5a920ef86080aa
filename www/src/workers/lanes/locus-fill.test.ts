import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import { COARSE, EPSILON, FINE, type Fineness, fillLocus, LocusFill, shareOf } from "./locus-fill";

const { size: SIZE, strides: STRIDES } = FINE;

/** Samples of a row range, all the same. */
function tile(r0: number, r1: number, stride: number, state: number, gap: number) {
  const count = Math.ceil((r1 - r0) / stride) * Math.ceil(SIZE / stride);
  return { state: new Uint8Array(count).fill(state), gap: new Float32Array(count).fill(gap) };
}

describe("a locus on its way", () => {
  it("has both ends of the morph among the samples of every stride", () => {
    for (const { size, strides } of [FINE, COARSE]) {
      for (const stride of strides) {
        expect((size - 1) % stride).toBe(0);
        expect(((size - 1) / 3) % stride).toBe(0);
      }
    }
  });

  it("is known everywhere after the coarsest stride", () => {
    const fill = new LocusFill(SIZE);
    fill.put(0, SIZE, 8, tile(0, SIZE, 8, STATE.connected, 0));
    expect(fill.locus.state.every((s) => s === STATE.connected)).toBe(true);
  });

  it("lets a finer sample speak for its own surroundings alone", () => {
    const fill = new LocusFill(SIZE);
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
    const fill = new LocusFill(SIZE);
    fill.put(0, 1, 1, tile(0, 1, 1, STATE.disconnected, EPSILON / 2));
    expect(fill.locus.state[5]).toBe(STATE.hidden);
    expect(fill.locus.state[SIZE + 5]).toBe(STATE.pending);
  });

  it("keeps to the rows that it was given", () => {
    const fill = new LocusFill(SIZE);
    const { state, gap } = tile(40, 44, 1, STATE.disconnected, 0.25);
    state[SIZE] = STATE.none;
    fill.put(40, 44, 1, { state, gap });
    expect(fill.locus.state[41 * SIZE]).toBe(STATE.none);
    expect(fill.locus.state[44 * SIZE]).toBe(STATE.pending);
  });
});

describe("how far it is", () => {
  it("runs from 0 to 1 without going back", () => {
    const shares = STRIDES.flatMap((_, stage) => [0, 40, SIZE].map((r) => shareOf(FINE, stage, r)));
    expect(shares[0]).toBe(0);
    expect(shares.at(-1)).toBe(1);
    expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  });
});

/** All that is asked of a locus, whose samples take so long, and what came of it. */
async function filled(fineness: Fineness, milliseconds = 0) {
  const asked: number[] = [];
  const told: number[] = [];
  const context = {
    progress: ({ progress }: { progress: number }) => void told.push(progress),
    breathe: () => Promise.resolve(),
    transfer: () => {},
    keep: new Map<string, unknown>(),
  };
  let now = 0;
  const clock = vi.spyOn(performance, "now").mockImplementation(() => now);
  const { size } = fineness;
  const whole = await fillLocus(context, fineness, (r0, r1, stride) => {
    for (let r = r0; r < r1; r += stride) asked.push(r);
    const count = Math.ceil((r1 - r0) / stride) * Math.ceil(size / stride);
    now += count * milliseconds;
    const state = stride === 1 ? STATE.disconnected : STATE.touching;
    return { state: new Uint8Array(count).fill(state), gap: new Float32Array(count).fill(0.2) };
  });
  clock.mockRestore();
  return { asked, told, whole };
}

it("a locus is decided row by row, coarse first, until all is", async () => {
  const patience = Number.POSITIVE_INFINITY;
  const { asked, told, whole } = await filled({ size: 7, strides: [2, 1], patience }, 5);
  expect(asked).toEqual([0, 2, 4, 6, 0, 1, 2, 3, 4, 5, 6]);
  expect([...told].sort((a, b) => a - b)).toEqual(told);
  expect([whole.progress, whole.stride, whole.width]).toEqual([1, 1, 7]);
  expect(whole.state.every((state) => state === STATE.disconnected)).toBe(true);
});

it("a locus stays as coarse as there is time for", async () => {
  // 49 samples would take 490 ms.
  const { asked, whole } = await filled({ size: 7, strides: [2, 1], patience: 480 }, 10);
  expect(asked).toEqual([0, 2, 4, 6]);
  expect([whole.progress, whole.stride]).toEqual([1, 2]);
  expect(whole.state.every((state) => state === STATE.touching)).toBe(true);
});
