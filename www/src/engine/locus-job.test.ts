import { describe, expect, it, vi } from "vitest";
import { STATE } from "./breaks";
import { LocusWork, SIZE, STRIDES } from "./locus-job";
import type { Task } from "./protocol";

const inputs = { from: [], to: [], options: {} };

/** Answers a slice as the program would, with the row and column in the gap. */
function answer(task: Task<"locus">) {
  const rows = Math.ceil((task.r1 - task.r0) / task.stride);
  const state = new Uint8Array(rows * SIZE).fill(STATE.pending);
  const gap = new Float32Array(rows * SIZE).fill(Number.NaN);
  let count = 0;
  for (let r = task.r0, k = 0; r < task.r1; r += task.stride, k++) {
    for (let c = 0; c < SIZE; c += task.stride) {
      if (!task.first && r % (2 * task.stride) === 0 && c % (2 * task.stride) === 0) continue;
      state[k * SIZE + c] = STATE.connected;
      gap[k * SIZE + c] = r * 1000 + c;
      count++;
    }
  }
  return { state, gap, count };
}

function run(milliseconds: number) {
  const stage = vi.fn();
  const watch = { painted: vi.fn(), stage: (_: LocusWork, stride: number) => stage(stride), failed: vi.fn() };
  const work = new LocusWork(inputs, watch, () => 10);
  const job = work.job();
  let count = 0;
  let slices = 0;
  for (let task = job.next(); task; task = job.next()) {
    expect(task.r0 % task.stride).toBe(0);
    const { count: n, ...result } = answer(task);
    count += n;
    slices++;
    job.accept(task, result, milliseconds);
  }
  return { work, count, slices, stage };
}

describe("LocusWork", () => {
  it.each([0.01, 10, 1000])("asks for every sample exactly once when a slice takes %d ms", (milliseconds) => {
    const { work, count, stage } = run(milliseconds);
    expect(count).toBe(SIZE * SIZE);
    expect(work.progress).toBe(1);
    expect(work.raw.gap.every((g, i) => g === Math.floor(i / SIZE) * 1000 + (i % SIZE))).toBe(true);
    expect(stage.mock.calls.map(([stride]) => stride)).toEqual([...STRIDES]);
  });

  it("makes slices smaller when they take long", () => {
    expect(run(200).slices).toBeGreaterThan(run(1).slices);
  });

  it("has (0,0) and (1,1) among its coarsest samples", () => {
    expect((SIZE - 1) % (3 * STRIDES[0])).toBe(0);
  });

  it("nests: a coarse locus is made of the same samples", () => {
    const { work } = run(10);
    const coarse = work.nested(4);
    expect(coarse.width).toBe(64);
    expect(coarse.gap[64 * 3 + 5]).toBe(12 * 1000 + 20);
  });

  it("paints a coarse sample over the finer ones that are still open", () => {
    const work = new LocusWork(inputs, { painted() {}, stage() {}, failed() {} }, () => 1e9);
    const job = work.job();
    const task = job.next();
    if (!task) throw new Error("no slice");
    const { count: _, ...result } = answer(task);
    job.accept(task, result, 1);
    expect(work.coarse).toBe(true);
    expect(work.filled.state.every((s) => s === STATE.connected)).toBe(true);
    expect(work.raw.state.filter((s) => s === STATE.connected)).toHaveLength(64 * 64);
  });

  it("loses nothing when a coarse slice comes last, from a worker that took over", () => {
    const nested = vi.fn();
    const stage = (work: LocusWork, stride: number) =>
      nested(stride, work.nested(stride).state.includes(STATE.pending));
    const work = new LocusWork(inputs, { painted() {}, stage, failed() {} }, () => 10);
    const job = work.job();
    const late = job.next();
    if (!late) throw new Error("no slice");
    for (let task = job.next(); task; task = job.next()) job.accept(task, answer(task), 10);
    expect(nested).not.toHaveBeenCalled();
    expect(work.progress).toBeLessThan(1);
    job.accept(late, answer(late), 10);
    expect(nested.mock.calls).toEqual(STRIDES.map((stride) => [stride, false]));
    expect(work.progress).toBe(1);
    expect(work.filled).toEqual(work.raw);
  });
});
