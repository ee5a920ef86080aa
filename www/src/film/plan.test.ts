import { describe, expect, it } from "vitest";
import {
  bitrateOf,
  bytesWords,
  even,
  fileName,
  filmBytes,
  filmSeconds,
  frameCount,
  grouped,
  litPart,
  type Plan,
  planProblem,
  secondsLeft,
  timesOf,
  timeWords,
} from "./plan";

const plan: Plan = {
  kind: "mp4",
  width: 1280,
  height: 720,
  fps: 30,
  from: 0,
  to: 2,
  easing: "linear",
  hold: 0,
  quality: "good",
  samples: 4,
  fullColour: false,
  ground: null,
  clear: false,
  dither: true,
  photograph: false,
  captions: false,
  inset: false,
};

describe("frames", () => {
  it("are as many as there are in the time of the film", () => {
    for (const loop of ["once", "round"] as const) expect(frameCount(plan, loop)).toBe(60);
    expect([filmSeconds(plan, "pingpong"), frameCount(plan, "pingpong")]).toEqual([4, 120]);
    for (const loop of ["once", "round", "pingpong"] as const) {
      expect(timesOf(plan, loop)).toHaveLength(frameCount(plan, loop));
      expect(timesOf({ from: 0, to: 0.01, fps: 10 }, loop)).toEqual([0]);
    }
  });

  it("end with the end, where it ends there", () => {
    const times = timesOf({ from: 1, to: 7.1, fps: 24 }, "once");
    expect([times.length, times[0], times.at(-1)]).toEqual([146, 1, 7.1]);
    times.forEach((time, i) => {
      expect(time).toBeCloseTo(1 + (6.1 * i) / 145, 9);
    });
  });

  it("do not show the first again, where it goes round", () => {
    const times = timesOf({ from: 0, to: 6, fps: 30 }, "round");
    expect(times).toEqual(Array.from({ length: 180 }, (_, i) => i / 30));
  });

  it("show each moment there and back, where it goes to and fro", () => {
    expect(timesOf({ from: 1, to: 3, fps: 2 }, "pingpong")).toEqual([1, 1.5, 2, 2.5, 3, 2.5, 2, 1.5]);
  });

  it("stand still at both ends for as long as is asked for", () => {
    const held = { from: 1, to: 3, fps: 2, easing: "ease", hold: 1 } as const;
    expect([filmSeconds(held, "pingpong"), frameCount(held, "pingpong")]).toEqual([6, 12]);
    const there = [1, 1.3125, 2, 2.6875, 3];
    expect(timesOf(held, "pingpong")).toEqual([1, 1, ...there, 3, 3, 2.6875, 2, 1.3125]);
    expect([filmSeconds(held, "once"), frameCount(held, "once")]).toEqual([4, 8]);
    // What goes round has no ends.
    expect([filmSeconds(held, "round"), frameCount(held, "round")]).toEqual([2, 4]);
    // Hardly larger: the pixels of a frame that stands still are written once.
    const [bare, long] = [0, 10].map((hold) => filmBytes({ ...plan, kind: "apng", hold }, "once"));
    expect(long).toBe(bare);
  });

  it("are refused in words where there are too many", () => {
    expect(planProblem({ ...plan, to: 100_000 / 30 }, "round")).toContain("100,000 frames are too many");
    expect(planProblem({ ...plan, to: 120 }, "round")).toBeNull();
    expect(planProblem({ ...plan, to: 120 }, "pingpong")).toContain("at most 60 s");
    expect(planProblem({ ...plan, kind: "frames", to: 600 }, "round")).toContain("at most 120 s");
    expect(planProblem({ ...plan, to: 120, hold: 10 }, "pingpong")).toContain("at most 50 s");
    for (const hold of [-1, 11, Number.NaN])
      expect(planProblem({ ...plan, hold }, "once")).toContain("0 to 10 s");
  });
});

describe("a plan", () => {
  it("is refused where it is none", () => {
    expect(planProblem(plan, "once")).toBeNull();
    expect(planProblem({ ...plan, to: 0 }, "once")).toContain("later end");
    expect(planProblem({ ...plan, to: Number.NaN }, "once")).toContain("later end");
    expect(planProblem({ ...plan, fps: 61 }, "once")).toContain("1 to 60");
    expect(planProblem({ ...plan, fps: 0.5 }, "once")).toContain("1 to 60");
    expect(planProblem({ ...plan, fps: 1 }, "once")).toBeNull();
    expect(planProblem({ ...plan, kind: "gif", fps: 60 }, "once")).toContain("at most 50");
    expect(planProblem({ ...plan, kind: "gif", fps: 50 }, "once")).toBeNull();
    for (const width of [14, 4098, 101])
      expect(planProblem({ ...plan, width }, "once")).toContain("16 to 4,096");
    // Numbers have no size, and keys no frames.
    expect(planProblem({ ...plan, kind: "frames", width: 101 }, "once")).toBeNull();
    expect(planProblem({ ...plan, kind: "keys", to: 0 }, "once")).toBeNull();
  });

  it("is refused where its file would be larger than a browser holds", () => {
    const large = { ...plan, kind: "zip" as const, width: 3840, height: 2160, from: 0, to: 60, fps: 60 };
    expect(planProblem(large, "once")).toContain("more than a browser can hold");
    expect(planProblem({ ...large, kind: "mp4" }, "once")).toBeNull();
  });

  it("is refused where its frames would be drawn larger than can be", () => {
    const fine = { ...plan, samples: 16 as const };
    expect(planProblem({ ...fine, width: 1920, height: 1080 }, "once")).toBeNull();
    expect(planProblem({ ...fine, width: 2048, height: 2048 }, "once")).toBeNull();
    expect(planProblem({ ...fine, width: 3840, height: 2160 }, "once")).toContain("4 × 4 samples per pixel");
    expect(planProblem({ ...plan, width: 3840, height: 2160 }, "once")).toBeNull();
  });

  it("has even sides", () => {
    expect([15.2, 101, 480].map(even)).toEqual([16, 102, 480]);
  });

  it("says about how large it will be", () => {
    expect(bitrateOf(plan)).toBe(Math.round(1280 * 720 * 30 * 0.2));
    expect(bitrateOf({ ...plan, fullColour: true })).toBe(Math.round(1280 * 720 * 30 * 0.26));
    expect(bitrateOf({ ...plan, width: 16, height: 16 })).toBe(300e3);
    expect(filmBytes({ ...plan, quality: "best" }, "round")).toBeGreaterThan(2 * filmBytes(plan, "round"));
    const gif = (lit: number) => filmBytes({ ...plan, kind: "gif" }, "round", lit);
    expect(gif(0.5)).toBeGreaterThan(1e6);
    expect(gif(0.1)).toBeLessThan(0.3 * gif(0.5));
    const pixels = Uint8ClampedArray.of(9, 9, 9, 255, 1, 2, 3, 0, 1, 2, 3, 255, 9, 9, 8, 255);
    expect(litPart(pixels, [9, 9, 9])).toBe(0.5);
    expect(litPart(new Uint8ClampedArray(0), [0, 0, 0])).toBe(0);
  });
});

describe("words", () => {
  it("for bytes and times", () => {
    expect([12, 1500, 45_000, 2_340_000, 45e6, 36.8e9].map(bytesWords)).toEqual([
      "12 bytes",
      "1.5 kB",
      "45 kB",
      "2.3 MB",
      "45 MB",
      "37 GB",
    ]);
    expect([0.2, 7.2, 41, 58, 130, 7200].map(timeWords)).toEqual([
      "a moment",
      "8 s",
      "45 s",
      "1 min",
      "2 min",
      "2 h",
    ]);
    expect([7, 1000, 100_000, 1234567].map(grouped)).toEqual(["7", "1,000", "100,000", "1,234,567"]);
  });

  it("for the time left, once that can be told", () => {
    expect(secondsLeft(1, 10, 3)).toBeNull();
    expect(secondsLeft(5, 10, 3)).toBe(3);
    expect(secondsLeft(10, 10, 3)).toBe(0);
  });

  it("for the file", () => {
    const kinds = ["mp4", "webm", "gif", "apng", "zip", "frames", "keys"] as const;
    expect(kinds.map((kind) => fileName("fern", { kind }))).toEqual([
      "frond-fern.mp4",
      "frond-fern.webm",
      "frond-fern.gif",
      "frond-fern.png",
      "frond-fern.zip",
      "frond-fern-frames.json",
      "frond-fern.json",
    ]);
  });
});
