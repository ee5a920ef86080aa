import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import type { LocusView } from "#wasm/api";
import type { ByCard, Plane } from "#wasm/locus-card";
import type { Task } from "#workers/pool/protocol";
import { Pyramid, TILE } from "../pyramid";
import { windowOf } from "../window";
import { WindowWork } from "../window-job";
import { PATIENCE_MS, tilesByCard } from "./tiles";

const at: LocusView = { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 4, w: 0 };
const always = () => true;

function open(view = at) {
  const pyramid = new Pyramid({ family: "morph", inputs: { from: [], to: [], options: {} }, w: 0 });
  const coarse = vi.fn();
  const work = new WindowWork(pyramid, { painted() {}, coarse, failed() {} }, true);
  work.want(view);
  return { pyramid, work, coarse };
}

/** The u of each sample as its gap, and its state by u and v. */
function answer(of: Plane, state: (u: number, v: number) => number): ByCard {
  const { bounds, width, height } = of.options;
  if (!bounds) throw new Error("without bounds");
  const along = (low: number, high: number, k: number, count: number) =>
    low + ((high - low) * k) / (count - 1);
  const found: ByCard = {
    width,
    height,
    state: new Uint8Array(width * height),
    gap: new Float32Array(width * height),
    milliseconds: 1,
  };
  for (let k = 0; k < width * height; k++) {
    const u = along(bounds.u0, bounds.u1, k % width, width);
    const v = along(bounds.v0, bounds.v1, Math.floor(k / width), height);
    found.state[k] = state(u, v);
    found.gap[k] = u;
  }
  return found;
}

describe("tilesByCard", () => {
  it("fills the window, each sample with what was said of its place", async () => {
    const { pyramid, work, coarse } = open();
    const asked: Plane[] = [];
    const ask = async (of: Plane) => {
      asked.push(of);
      return answer(of, (u, v) => (u + v > 1 ? STATE.touching : STATE.disconnected));
    };
    await tilesByCard({ ask, pace: 1e-4 }, work, always);
    expect(work.progress).toBe(1);
    expect(coarse).toHaveBeenCalledOnce();
    expect(work.job().next()).toBeNull();
    // A card that is quick is asked once.
    expect(asked).toHaveLength(1);
    const { state, gap, width, bounds } = pyramid.read(windowOf(at), at.zoom);
    for (let k = 0; k < state.length; k += 97) {
      const u = bounds.u0 + ((bounds.u1 - bounds.u0) * (k % width)) / (width - 1);
      const v = bounds.v0 + ((bounds.v1 - bounds.v0) * Math.floor(k / width)) / (state.length / width - 1);
      expect(gap[k]).toBeCloseTo(u, 5);
      if (Math.abs(u + v - 1) > 1e-6) expect(state[k]).toBe(u + v > 1 ? STATE.touching : STATE.disconnected);
    }
  });

  it("leaves to the workers what has something undecided, and does not ask for it again", async () => {
    const { pyramid, work } = open();
    const ask = vi.fn(async (of: Plane) =>
      answer(of, (u, v) => (Math.hypot(u - 0.5, v - 0.5) < 0.01 ? STATE.undecided : STATE.touching)),
    );
    await tilesByCard({ ask, pace: 1e-4 }, work, always);
    expect(work.progress).toBeLessThan(1);
    expect(work.progress).toBeGreaterThan(0.5);
    const times = ask.mock.calls.length;
    await tilesByCard({ ask, pace: 1e-4 }, work, always);
    expect(ask).toHaveBeenCalledTimes(times);
    const job = work.job();
    const tasks: Task<"patch" | "locus">[] = [];
    for (let task = job.next(); task; task = job.next()) {
      tasks.push(task);
      if (task.kind !== "patch") throw new Error("as rectangles");
      const count = (task.x1 - task.x0) * (task.y1 - task.y0);
      job.accept(
        task,
        { state: new Uint8Array(count).fill(STATE.disconnected), gap: new Float32Array(count) },
        1,
      );
    }
    expect(tasks.length).toBeGreaterThan(0);
    expect(tasks.length).toBeLessThan(pyramid.missing(windowOf(at), at.zoom).count / 2);
    expect(work.progress).toBe(1);
  });

  it("gives back what the card has no answer for, and takes nothing that is not wanted", async () => {
    const { work } = open();
    const ask = vi.fn(async () => null);
    await tilesByCard({ ask, pace: 1e-4 }, work, () => false);
    expect(ask).not.toHaveBeenCalled();
    const before = work.open.length;
    await tilesByCard({ ask, pace: 1e-4 }, work, always);
    expect(ask).toHaveBeenCalledOnce();
    expect(work.open).toHaveLength(before);
  });

  it("is not waited for where it takes long: who is first is heard", async () => {
    vi.useFakeTimers();
    const { pyramid, work } = open();
    let answered = (_: ByCard | null) => {};
    let asked: Plane | null = null;
    const ask = (of: Plane) => {
      asked = of;
      return new Promise<ByCard | null>((resolve) => {
        answered = resolve;
      });
    };
    const ended = tilesByCard({ ask, pace: 1e-4 }, work, always);
    expect(work.open).toHaveLength(0);
    vi.advanceTimersByTime(PATIENCE_MS + 1);
    vi.useRealTimers();
    const all = work.open.length;
    expect(all).toBeGreaterThan(20);
    const job = work.job();
    const [first, second] = [job.next(), job.next()];
    if (first?.kind !== "patch" || second?.kind !== "patch") throw new Error("two tiles");
    const by = (task: Task<"patch">, state: number) => {
      const count = (task.x1 - task.x0) * (task.y1 - task.y0);
      return { state: new Uint8Array(count).fill(state), gap: new Float32Array(count) };
    };
    job.accept(first, by(first, STATE.disconnected), 1);
    expect(work.progress).toBeCloseTo(1 / all, 9);
    if (asked) answered(answer(asked, () => STATE.touching));
    await ended;
    expect(work.progress).toBe(1);
    expect(job.next()).toBeNull();
    job.accept(second, by(second, STATE.disconnected), 1);
    expect(pyramid.read(windowOf(at), at.zoom).state.includes(STATE.disconnected)).toBe(false);
  });

  it.each([
    [1e-4, [5]],
    [1, [3, 1, 1]],
  ])("asks for less at once where it takes long (%d ms a sample)", async (pace, rows) => {
    const heights: number[] = [];
    const ask = async (of: Plane) => {
      heights.push(Math.ceil(of.options.height / TILE));
      return answer(of, () => STATE.touching);
    };
    await tilesByCard({ ask, pace }, open({ ...at, zoom: 8 }).work, always);
    expect(heights).toEqual(rows);
  });
});
