import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import type { Task } from "#workers/pool/protocol";
import { LocusWork, patchesOf, SIZE, STRIDES } from "./job";

const inputs = { from: [], to: [], options: {} };

/** Answers a slice as the program would, with the row and column in the gap. */
function answer(task: Task<"locus" | "patch">) {
  return task.kind === "locus" ? answerRows(task) : answerPatch(task);
}

function answerPatch({ x0, y0, x1, y1 }: Task<"patch">) {
  const width = x1 - x0;
  const count = width * (y1 - y0);
  const gap = Float32Array.from(
    { length: count },
    (_, k) => (y0 + Math.floor(k / width)) * 1000 + x0 + (k % width),
  );
  return { state: new Uint8Array(count).fill(STATE.connected), gap, count };
}

function answerRows(task: Task<"locus">) {
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

function run(milliseconds: number, patches = false) {
  const stage = vi.fn();
  const watch = { painted: vi.fn(), stage: (_: LocusWork, stride: number) => stage(stride), failed: vi.fn() };
  const means = { patches, priorities: (): [number, number] => [50, 15] };
  const work = new LocusWork(inputs, watch, () => 10, means);
  const job = work.job();
  let count = 0;
  let slices = 0;
  for (let task = job.next(); task; task = job.next()) {
    if (task.kind === "locus") expect(task.r0 % task.stride).toBe(0);
    const { count: n, ...result } = answer(task);
    count += n;
    slices++;
    job.accept(task, result, milliseconds);
  }
  return { work, count, slices, stage };
}

describe("LocusWork", () => {
  it("takes all samples at once, and leaves to the patches what is undecided there", () => {
    const stage = vi.fn();
    const watch = {
      painted: vi.fn(),
      stage: (_: LocusWork, stride: number) => stage(stride),
      failed: vi.fn(),
    };
    const work = new LocusWork(inputs, watch, () => 1e9, { patches: true, priorities: () => [50, 15] });
    const job = work.job();
    const coarse = job.next();
    const state = new Uint8Array(SIZE * SIZE).fill(STATE.touching);
    // One sample of the last patch, and one of the coarse picture.
    state[SIZE * SIZE - 2] = STATE.undecided;
    state[0] = STATE.undecided;
    work.acceptWhole({ state, gap: new Float32Array(SIZE * SIZE) });
    expect(work.progress).toBeCloseTo(1 - 2 / (SIZE * SIZE), 9);
    expect(stage).not.toHaveBeenCalled();
    if (coarse?.kind !== "locus") throw new Error("the coarse picture comes first");
    job.accept(coarse, answer(coarse), 1);
    expect(stage.mock.calls).toEqual([[4]]);
    const patches: Task<"patch">[] = [];
    for (let task = job.next(); task; task = job.next()) {
      if (task.kind !== "patch") throw new Error("then the patches");
      patches.push(task);
      job.accept(task, answer(task), 1);
    }
    // The two corners: all others are done.
    const corners = patches.map(({ x0, y0, x1, y1 }) => [x0 === 0 && y0 === 0, x1 === SIZE && y1 === SIZE]);
    expect(corners.sort()).toEqual([
      [false, true],
      [true, false],
    ]);
    expect(work.progress).toBe(1);
    expect(stage.mock.calls).toEqual([[4], [1]]);
    expect(work.raw.state[126 * SIZE + 127]).toBe(STATE.touching);
  });

  it("asks for no coarse picture of what is known but for a few samples", () => {
    const watch = { painted: vi.fn(), stage: vi.fn(), failed: vi.fn() };
    const work = new LocusWork(inputs, watch, () => 1e9, { patches: true, priorities: () => [50, 15] });
    const state = new Uint8Array(SIZE * SIZE).fill(STATE.touching);
    state[100 * SIZE + 100] = STATE.undecided;
    work.acceptWhole({ state, gap: new Float32Array(SIZE * SIZE) });
    const job = work.job();
    const task = job.next();
    if (task?.kind !== "patch") throw new Error("a rectangle");
    expect(task.x1 - task.x0).toBeLessThan(40);
    expect(job.next()).toBeNull();
    job.accept(task, answer(task), 1);
    expect(work.progress).toBe(1);
  });

  it.each([0.01, 10, 1000])("asks for every sample exactly once when a slice takes %d ms", (milliseconds) => {
    const { work, count, stage } = run(milliseconds);
    expect(count).toBe(SIZE * SIZE);
    expect(work.progress).toBe(1);
    expect(work.raw.gap.every((g, i) => g === Math.floor(i / SIZE) * 1000 + (i % SIZE))).toBe(true);
    expect(stage.mock.calls.map(([stride]) => stride)).toEqual([...STRIDES]);
  });

  it("asks for a coarse picture, and then for rectangles, where they can be had", () => {
    const { work, stage, slices } = run(1, true);
    expect(work.progress).toBe(1);
    expect(work.raw.gap.every((g, i) => g === Math.floor(i / SIZE) * 1000 + (i % SIZE))).toBe(true);
    expect(work.filled).toEqual(work.raw);
    expect(stage.mock.calls.map(([stride]) => stride)).toEqual([STRIDES[0], 1]);
    expect(slices).toBeGreaterThanOrEqual(17);
  });

  it("may begin with a finer picture, every second sample in its place", () => {
    const stage = vi.fn();
    const watch = { painted: vi.fn(), stage: (_: LocusWork, by: number) => stage(by), failed: vi.fn() };
    const means = { patches: true, first: 2, priorities: (): [number, number] => [50, 15] } as const;
    const work = new LocusWork(inputs, watch, () => 10, means);
    const job = work.job();
    while (stage.mock.calls.length === 0) {
      expect(job.priority()).toBe(50);
      const task = job.next();
      if (task?.kind !== "patch") throw new Error("the finer picture is made of patches");
      job.accept(task, answerPatch(task), 1);
    }
    expect(stage.mock.calls).toEqual([[2]]);
    for (let r = 0; r < SIZE; r += 2) {
      for (let c = 0; c < SIZE; c += 2)
        if (work.raw.gap[r * SIZE + c] !== (r / 2) * 1000 + c / 2)
          throw new Error(`not in place: ${r}, ${c}`);
    }
    expect(work.filled.state.includes(STATE.pending)).toBe(false);
    expect(work.nested(4).state.includes(STATE.pending)).toBe(false);
    expect(job.priority()).toBe(15);
  });

  it("covers the square with rectangles, each sample once, from the middle outwards", () => {
    const seen = new Uint8Array(SIZE * SIZE);
    const rectangles = patchesOf(SIZE, 64);
    for (const { x0, y0, x1, y1 } of rectangles) {
      for (let y = y0; y < y1; y++)
        for (let x = x0; x < x1; x++) seen[y * SIZE + x] = (seen[y * SIZE + x] ?? 0) + 1;
    }
    expect(seen.every((n) => n === 1)).toBe(true);
    const far = rectangles.map(({ x0, x1, y0, y1 }) => Math.hypot(x0 + x1 - SIZE, y0 + y1 - SIZE));
    expect(far).toEqual(far.toSorted((p, q) => p - q));
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

  it("tells gaps that are not seen apart, and tells the program only what it knows", () => {
    const watch = { painted() {}, stage() {}, failed() {} };
    const work = new LocusWork(inputs, watch, () => 10, { patches: true, priorities: () => [50, 15] });
    const state = new Uint8Array(SIZE * SIZE).fill(STATE.disconnected);
    work.acceptWhole({ state, gap: new Float32Array(SIZE * SIZE).fill(1e-4) });
    expect(work.raw.state.every((s) => s === STATE.hidden)).toBe(true);
    for (const stride of STRIDES)
      expect(work.nested(stride).state.every((s) => s === STATE.disconnected)).toBe(true);
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
