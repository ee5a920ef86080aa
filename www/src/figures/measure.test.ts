import { describe, expect, it } from "vitest";
import type { Result, Task } from "../engine/protocol";
import { exactJob, MARGIN, measureJob, RUNS, SIZES, searches, shifted, shiftOf, WINDOWS } from "./measure";

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

describe("shifted", () => {
  it("moves the middle of the box by so many pixels and keeps the window's side", () => {
    const { ifs, margin } = shifted(0.5, 75, [0.5, 0.25]);
    const [, , , , x = 0, y = 0] = ifs.maps[3] ?? [];
    const pixel = (1 + MARGIN) / 75;
    expect(-x / 2).toBeCloseTo(0.5 * pixel, 12);
    expect(-y / 2).toBeCloseTo(0.25 * pixel, 12);
    expect((1 - x) * (1 + margin)).toBeCloseTo(1 + MARGIN, 12);
    expect(ifs.probabilities).toEqual([1, 1, 1, 0]);
  });
  it("leaves all of the gasket inside, whatever the shift", () => {
    for (const size of SIZES) expect(shifted(0.5, size, [1, 1]).margin).toBeGreaterThan(0);
    for (let i = 0; i < WINDOWS; i++) {
      for (const part of shiftOf(i)) expect(part >= 0 && part < 1).toBe(true);
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
