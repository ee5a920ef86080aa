import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import type { LocusView } from "#wasm/api";
import type { Task } from "#workers/pool/protocol";
import { type LocusSource, Pyramid, TILE } from "./pyramid";
import { epsilonOf, homeOf, samplesAt, windowOf } from "./window";
import { WindowWork } from "./window-job";

const morph: LocusSource = { family: "morph", inputs: { from: [], to: [], options: {} }, w: 0 };
const polygon: LocusSource = { family: "polygon", sides: 2 };
const view = (zoom: number, x = 0.5, y = 0.5): LocusView => ({ family: "morph", sides: 2, x, y, zoom, w: 0 });

/** Where each sample lies is told in the answers: its u in the gap, so that it can be seen to arrive there. */
function answer(task: Task<"locus" | "patch">) {
  const { bounds, width, height } = (task.kind === "patch" ? task.of : task).options;
  const home = homeOf("morph");
  const { u0, u1 } = bounds ?? home;
  const [x0, x1, y0, y1] =
    task.kind === "patch" ? [task.x0, task.x1, task.y0, task.y1] : [0, width, task.r0, task.r1];
  expect(y1).toBeLessThanOrEqual(height);
  const state = new Uint8Array((x1 - x0) * (y1 - y0)).fill(STATE.disconnected);
  const gap = new Float32Array(state.length);
  for (let k = 0; k < gap.length; k++) {
    const x = x0 + (k % (x1 - x0));
    gap[k] = 10 + (width > 1 ? u0 + ((u1 - u0) * x) / (width - 1) : u0);
  }
  return { state, gap };
}

function work(pyramid: Pyramid, at: LocusView, patches: boolean, most = Number.POSITIVE_INFINITY) {
  const watch = { painted: vi.fn(), coarse: vi.fn(), failed: vi.fn() };
  const found = new WindowWork(pyramid, watch, patches);
  found.want(at);
  const job = found.job();
  const tasks: Task<"locus" | "patch">[] = [];
  while (tasks.length < most) {
    const task = job.next();
    if (!task) break;
    tasks.push(task);
    job.accept(task, answer(task), 1);
  }
  return { found, job, tasks, watch };
}

describe("Pyramid", () => {
  it.each([true, false])("fills a window anywhere, at any depth (patches: %s)", (patches) => {
    for (const [zoom, x, y] of [
      [2, 0.5, 0.5],
      [100, -0.9, 1.9],
      [1e6, 0.123456789, 0.75],
      [1e13, 0.5, 0.7],
    ] as const) {
      const pyramid = new Pyramid(morph);
      const at = view(zoom, x, y);
      const { found, watch } = work(pyramid, at, patches);
      expect(found.progress).toBe(1);
      expect(watch.coarse).toHaveBeenCalledTimes(1);
      const field = pyramid.read(windowOf(at), zoom);
      expect(field.state.every((s) => s === STATE.disconnected)).toBe(true);
      const window = windowOf(at);
      expect(field.bounds.u0).toBeLessThanOrEqual(window.u0 + 1e-15);
      expect(field.bounds.v1).toBeGreaterThanOrEqual(window.v1 - 1e-15);
      const middle = Math.floor(field.height / 2) * field.width + Math.floor(field.width / 2);
      expect((field.gap[middle] ?? 0) - 10).toBeCloseTo(x, 1);
    }
  });

  it("puts every sample where it belongs", () => {
    const pyramid = new Pyramid(morph);
    const at = view(8, 0.4, 0.6);
    work(pyramid, at, true);
    const { width, height, gap, bounds } = pyramid.read(windowOf(at), 8);
    for (let c = 0; c < width; c++) {
      const u = bounds.u0 + ((bounds.u1 - bounds.u0) * c) / (width - 1);
      expect(gap[c]).toBeCloseTo(10 + u, 4);
      expect(gap[(height - 1) * width + c]).toBeCloseTo(10 + u, 4);
    }
  });

  it("asks for a coarse picture first, the middle first, and for nothing twice", () => {
    const pyramid = new Pyramid(polygon);
    const at: LocusView = { ...view(1, 0, 0), family: "polygon" };
    const { found, job, tasks } = work(pyramid, at, true);
    expect(tasks).toHaveLength(32);
    const coarse = tasks.slice(0, 16);
    expect(coarse.every((t) => t.kind === "patch" && t.x1 - t.x0 <= TILE / 4)).toBe(true);
    expect(new Set(tasks.slice(16).map((t) => t.kind === "patch" && `${t.x0},${t.y0}`)).size).toBe(16);
    expect(found.want(at)).toBe(false);
    expect(job.next()).toBeNull();
  });

  it("shows coarser samples where the finer ones are missing", () => {
    const pyramid = new Pyramid(morph);
    work(pyramid, view(2), true);
    const near = windowOf(view(16));
    const field = pyramid.read(near, 16);
    expect(field.state.every((s) => s === STATE.disconnected)).toBe(true);
    expect(field.epsilon).toBe(epsilonOf(4));
    // What was seen already is not asked for coarsely again.
    expect(pyramid.missing(windowOf(view(8)), 8).coarse).toEqual([]);
    expect(pyramid.missing(near, 16).coarse.length).toBeGreaterThan(0);
  });

  it("shows samples of finer tiles where one has looked nearer, and judges them as coarsely as all", () => {
    const pyramid = new Pyramid(morph);
    // Gaps of 10 and more: no coarse sample is within epsilon, but for those that are put there.
    work(pyramid, view(4, 0.4, 0.6), true);
    const field = pyramid.read(windowOf(view(2, 0.4, 0.6)), 2);
    const { width, height, bounds, state, gap } = field;
    const near = windowOf(view(4, 0.4, 0.6));
    let seen = 0;
    for (let k = 0; k < width * height; k++) {
      const u = bounds.u0 + ((bounds.u1 - bounds.u0) * (k % width)) / (width - 1);
      const v = bounds.v0 + ((bounds.v1 - bounds.v0) * Math.floor(k / width)) / (height - 1);
      if (u < near.u0 || u > near.u1 || v < near.v0 || v > near.v1) continue;
      seen++;
      expect(state[k]).toBe(STATE.disconnected);
      expect(gap[k]).toBeCloseTo(10 + u, 4);
    }
    expect(seen).toBeGreaterThan((0.24 * width * height) | 0);
    const narrow = epsilonOf(2) * 1.5;
    const id = { level: 2, i: 7, j: 7 };
    const { width: side, height: rows } = pyramid.place(id);
    const fill = { state: new Uint8Array(side * rows).fill(STATE.disconnected), width: side };
    pyramid.put(id, "fine", { ...fill, gap: new Float32Array(side * rows).fill(narrow) });
    const at = pyramid.boundsOf(2, { x0: 7 * TILE, y0: 7 * TILE, x1: 7 * TILE, y1: 7 * TILE });
    expect(pyramid.read({ ...at }, 4).state[0]).toBe(STATE.disconnected);
    expect(pyramid.read({ ...at }, 2).state[0]).toBe(STATE.hidden);
  });

  it("asks for the new strip alone when one moves, and shows the rest as it was", () => {
    const pyramid = new Pyramid(morph);
    const before = view(8, 0.4, 0.6);
    work(pyramid, before, true);
    // Moved by two fifths of what is seen.
    const after = view(8, 0.4 + (0.4 * 3) / 8, 0.6);
    const [from, to] = [windowOf(before), windowOf(after)];
    expect(pyramid.missing(from, 8).fine).toEqual([]);
    const { fine, count } = pyramid.missing(to, 8);
    expect(fine.length).toBeGreaterThan(0);
    expect(fine.length).toBeLessThan(0.6 * count);
    const { width, height, bounds, state } = pyramid.read(to, 8);
    for (let k = 0; k < width * height; k++) {
      const u = bounds.u0 + ((bounds.u1 - bounds.u0) * (k % width)) / (width - 1);
      if (u <= from.u1) expect(state[k]).toBe(STATE.disconnected);
    }
  });

  it("keeps what is looked at, however much is looked at elsewhere", () => {
    const pyramid = new Pyramid(morph);
    const here = view(2);
    work(pyramid, here, true);
    const put = (k: number) => {
      const id = { level: 12, i: k % 60, j: Math.floor(k / 60) };
      const samples = { width: TILE, state: new Uint8Array(TILE * TILE), gap: new Float32Array(TILE * TILE) };
      pyramid.put(id, "fine", samples);
    };
    for (let k = 0; k < 2500; k++) {
      put(k);
      if (k % 500 === 0) expect(pyramid.missing(windowOf(here), 2).fine).toEqual([]);
    }
    expect(pyramid.missing(windowOf(here), 2).fine).toEqual([]);
    for (let k = 0; k < 2500; k++) put(k);
    expect(pyramid.missing(windowOf(here), 2).fine.length).toBeGreaterThan(0);
  });

  it("takes level 0 from where it is kept, and is content with it", () => {
    const size = samplesAt(0);
    const base = {
      width: size,
      height: size,
      state: new Uint8Array(size * size).fill(STATE.touching),
      gap: new Float32Array(size * size),
      progress: 1,
    };
    const pyramid = new Pyramid(morph, () => base);
    expect(pyramid.missing(homeOf("morph"), 1)).toEqual({ coarse: [], fine: [], count: 0 });
    const field = pyramid.read(homeOf("morph"), 1);
    expect([field.width, field.height]).toEqual([size, size]);
    expect(field.state).toEqual(base.state);
    expect(pyramid.read(windowOf(view(20)), 20).state.every((s) => s === STATE.touching)).toBe(true);
    expect(pyramid.missing(windowOf(view(4)), 4).coarse).toEqual([]);
    base.progress = 0.5;
    expect(pyramid.missing(windowOf(view(4)), 4).coarse).not.toEqual([]);
  });

  it("shows the plane before until something is known of this one", () => {
    const before = new Pyramid(morph);
    work(before, view(4), true);
    const after = new Pyramid({ ...morph, w: 0.1 }, null, before);
    const window = windowOf(view(4));
    expect(after.read(window, 4).state.includes(STATE.pending)).toBe(false);
    after.forget();
    expect(after.read(window, 4).state.every((s) => s === STATE.pending)).toBe(true);
  });

  it("shows one plane at a time, however much of the next is there, and whatever becomes of the base", () => {
    const size = samplesAt(0);
    const base = (state: number, progress: number) => ({
      width: size,
      height: size,
      state: new Uint8Array(size * size).fill(state),
      gap: new Float32Array(size * size),
      progress,
    });
    let whole = base(STATE.touching, 0.9);
    const before = new Pyramid(morph, () => whole);
    work(before, view(4), true, 3);
    const window = windowOf(view(4));
    // As one word: two long arrays that differ take minutes to be told apart.
    const shown = (pyramid: Pyramid) => pyramid.read(window, 4).state.join();
    const last = shown(before);
    const after = new Pyramid({ ...morph, w: 0.1 }, () => whole, before);
    whole = base(STATE.hidden, 0);
    work(after, view(4), true, 3);
    expect(shown(after) === last).toBe(true);
    // What never came to be shown is not what is shown next.
    const third = new Pyramid({ ...morph, w: 0.2 }, () => whole, after.shown);
    expect(shown(third) === last).toBe(true);
    third.forget();
    // A base of which nothing is known yet is still that of another plane.
    expect(third.read(window, 4).state.every((s) => s === STATE.pending)).toBe(true);
    whole = { ...whole, progress: 0.1 };
    expect(third.read(window, 4).state.every((s) => s === STATE.hidden)).toBe(true);
  });

  it("says of a large map that something is known everywhere when it is, and not with the first tile", () => {
    const size = samplesAt(0);
    const [state, gap] = [new Uint8Array(size * size), new Float32Array(size * size)];
    const pyramid = new Pyramid(morph, () => ({ width: size, height: size, state, gap, progress: 0 }));
    const watch = { painted: vi.fn(), coarse: vi.fn(), failed: vi.fn() };
    const found = new WindowWork(pyramid, watch, true);
    found.want(view(1), 2);
    const tiles = pyramid.missing(homeOf("morph"), 2).coarse.length;
    expect(tiles).toBe(64);
    const job = found.job();
    for (let k = 0; k < tiles; k++) {
      expect(watch.coarse).not.toHaveBeenCalled();
      const task = job.next();
      if (!task) throw new Error("no task");
      job.accept(task, answer(task), 1);
    }
    expect(watch.coarse).toHaveBeenCalledTimes(1);
  });

  it("ends what was begun when one looks elsewhere and back", () => {
    const pyramid = new Pyramid(morph);
    const { found, job } = work(pyramid, view(3), false, 40);
    found.want(view(3, 1.4, 1.4));
    for (let task = job.next(); task; task = job.next()) job.accept(task, answer(task), 1);
    expect(found.progress).toBe(1);
    found.want(view(3));
    for (let task = job.next(); task; task = job.next()) job.accept(task, answer(task), 1);
    expect(found.progress).toBe(1);
    expect(pyramid.read(windowOf(view(3)), 3).state.includes(STATE.pending)).toBe(false);
  });

  it("tells a gap within epsilon from one that is seen, at the epsilon of its depth", () => {
    const pyramid = new Pyramid(morph);
    const watch = { painted() {}, coarse() {}, failed() {} };
    const found = new WindowWork(pyramid, watch, true);
    found.want(view(4));
    const job = found.job();
    for (let task = job.next(); task; task = job.next()) {
      const { state } = answer(task);
      job.accept(task, { state, gap: new Float32Array(state.length).fill(0.999 * epsilonOf(2)) }, 1);
    }
    expect(pyramid.read(windowOf(view(4)), 4).state.every((s) => s === STATE.hidden)).toBe(true);
  });
});
