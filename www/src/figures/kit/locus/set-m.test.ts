import { describe, expect, it } from "vitest";
import type { LocusResult } from "#compute/results";
import { STATE } from "#geometry/states";
import type { Connectedness } from "#wasm/api";
import { determinant } from "../maps/families";
import { blankQuarter, knownState, mapsOf, quarterJob, REACH, unfolded } from "./set-m";

const TOUCHING: Connectedness = {
  verdict: "touching",
  gap: { lower: 0, upper: 0 },
  overlaps: [[0, 1]],
  components: [0, 0],
  count: 1,
  diameter: 4,
  nodes: 1,
};

describe("the set M", () => {
  it("has two maps that shrink by the size of s", () => {
    for (const map of mapsOf([0.3, 0.4])) expect(determinant(map)).toBeCloseTo(0.25, 12);
    expect(mapsOf([0.3, 0.4]).map((map) => map[4])).toEqual([-1, 1]);
  });

  it("is known by the size of s alone but for a ring", () => {
    expect(knownState([0.3, 0.3])).toBe(STATE.disconnected);
    expect(knownState([0, 0.72])).toBe(STATE.connected);
    expect(knownState([0.7, 0.7])).toBe(STATE.pending);
    expect(knownState([0.5, 0])).toBeNull();
    expect(knownState([0.4, 0.5])).toBeNull();
  });

  it("is unfolded from a quarter with all its symmetries", () => {
    const quarter = blankQuarter(4);
    quarter.state.set([9, 8, 7, 6], 0);
    const { width, state } = unfolded(quarter);
    expect(width).toBe(7);
    expect([...state.subarray(21, 28)]).toEqual([6, 7, 8, 9, 8, 7, 6]);
    for (let row = 0; row < 7; row++) {
      expect(state.subarray(7 * row, 7 * row + 7)).toEqual(state.subarray(7 * (6 - row), 7 * (6 - row) + 7));
    }
  });
});

describe("its quarter", () => {
  it("asks only for what is open, sample by sample", () => {
    let last = blankQuarter(2);
    const job = quarterJob("figure:0", 31, false, (quarter) => {
      last = quarter;
    });
    let asked = 0;
    for (let task = job.next(); task; task = job.next()) {
      if (task.kind !== "verdict") throw new Error("no patches were offered");
      const [re, , im] = task.maps[0] ?? [0, 0, 0];
      expect(knownState([re, im])).toBeNull();
      job.accept(task, TOUCHING, 1);
      asked++;
    }
    expect(asked).toBeGreaterThan(100);
    expect(last.progress).toBe(1);
    expect(count(last, STATE.touching)).toBe(asked);
    expect(last.state[0]).toBe(STATE.disconnected);
    expect(last.state[31 * 31 - 1]).toBe(STATE.pending);
  });

  it("takes patches where they are to be had, and nothing beyond the disc", () => {
    let last = blankQuarter(2);
    const job = quarterJob("figure:0", 100, true, (quarter) => {
      last = quarter;
    });
    let samples = 0;
    for (let task = job.next(); task; task = job.next()) {
      if (task.kind !== "patch") throw new Error("patches were offered");
      const length = (task.x1 - task.x0) * (task.y1 - task.y0);
      samples += length;
      const state = new Uint8Array(length).fill(STATE.touching);
      job.accept(task, { state, gap: new Float32Array(length) }, 1);
    }
    expect(samples).toBe(100 * 100);
    expect(last.progress).toBe(1);
    expect(last.state[0]).toBe(STATE.touching);
    expect(last.state[Math.round((0.6 / REACH) * 99)]).toBe(STATE.touching);
    expect(last.state[100 * 100 - 1]).toBe(STATE.pending);
  });
});

function count({ state }: LocusResult, wanted: number): number {
  return state.filter((s) => s === wanted).length;
}
