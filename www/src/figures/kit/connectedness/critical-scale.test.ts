import { describe, expect, it } from "vitest";
import type { Result, Task } from "#workers/pool/protocol";
import {
  exactJob,
  MARGIN,
  measureJob,
  RUNS,
  runTask,
  SIZES,
  searches,
  shiftOf,
  WINDOWS,
  windowOf,
} from "./critical-scale";

type Buffered = Result<"buffer">;
const answer = (connected: boolean): Buffered => ({
  components: connected ? [0, 0, 0, 1] : [0, 1, 0, 2],
  overlaps: [],
});

describe("measureJob", () => {
  it("finds the turn of every search, never asking one twice at a time", () => {
    const all = searches();
    let done = 0;
    let answered = 0;
    const job = measureJob(
      "figure:test",
      all,
      { points: 10, seed: 1 },
      {
        progress: () => answered++,
        done: () => done++,
        fail: () => {},
      },
    );
    const flying: Task<"buffer">[] = [];
    for (;;) {
      const task = flying.length < 3 ? job.next() : null;
      if (task) {
        flying.push(task);
        continue;
      }
      const back = flying.shift();
      if (!back) break;
      const turn = 0.49 + back.options.size / 100_000;
      job.accept(back, answer((back.ifs.maps[0]?.[0] ?? 0) >= turn), 1);
    }
    expect(answered).toBe(RUNS);
    for (const { size, bisection } of all) {
      expect(bisection.high).toBeGreaterThanOrEqual(0.49 + size / 100_000);
      expect(bisection.high - bisection.low).toBeLessThanOrEqual(1e-4);
    }
    expect(all).toHaveLength(SIZES.length * (WINDOWS + 1));
    job.done?.();
    expect(done).toBe(1);
  });
});

describe("windowOf", () => {
  it("moves by so many pixels and keeps its side", () => {
    const pixel = (1 + MARGIN) / 75;
    const [x0, y0, x1, y1] = windowOf(75, [0.5, 0.25]);
    expect((x0 + x1) / 2).toBeCloseTo(0.5 - 0.5 * pixel, 12);
    expect((y0 + y1) / 2).toBeCloseTo(Math.sqrt(0.75) / 2 - 0.25 * pixel, 12);
    expect([x1 - x0, y1 - y0]).toEqual([expect.closeTo(1 + MARGIN, 12), expect.closeTo(1 + MARGIN, 12)]);
  });
  it("leaves all of the gasket inside, whatever the shift", () => {
    for (const size of SIZES) {
      const [x0, y0, x1, y1] = windowOf(size, [1, 1]);
      expect(x0 < 0 && y0 < 0 && x1 > 1 && y1 > Math.sqrt(0.75)).toBe(true);
    }
    for (let i = 0; i < WINDOWS; i++) {
      for (const part of shiftOf(i)) expect(part >= 0 && part < 1).toBe(true);
    }
  });
  it("is all that a question has beside the gasket's three maps", () => {
    for (const search of searches()) {
      const { ifs, options } = runTask(search, 10, 1);
      expect(ifs.maps).toHaveLength(3);
      expect(ifs.probabilities).toBeUndefined();
      const shifted = search.window === null ? undefined : windowOf(search.size, shiftOf(search.window));
      expect(options.window).toEqual(shifted);
    }
  });
});

describe("exactJob", () => {
  it("closes in on what is not proved disconnected", () => {
    let found = 0;
    const job = exactJob("figure:test", 1e-6, (r) => {
      found = r;
    });
    for (let task = job.next(); task; task = job.next()) {
      expect(job.next()).toBeNull();
      const verdict = (task.maps[0]?.[0] ?? 0) < 0.4999999 ? "disconnected" : "touching";
      const rest = {
        gap: { lower: 0, upper: 0 },
        overlaps: [],
        components: [],
        count: 1,
        diameter: 1,
        nodes: 0,
      };
      job.accept(task, { verdict, ...rest }, 1);
    }
    job.done?.();
    expect(found).toBeCloseTo(0.4999999, 7);
  });
});
