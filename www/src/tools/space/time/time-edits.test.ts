import { describe, expect, it } from "vitest";
import type { SpaceTimeline } from "#wasm/api";
import {
  jumpsBack,
  keyAt,
  momentIn,
  nextKey,
  secondsProblem,
  stretched,
  withEase,
  withKeyAt,
  withLoop,
  withoutKey,
  withSeconds,
} from "./time-edits";

const line: SpaceTimeline = {
  seconds: 6,
  loop: "once",
  course: "smooth",
  keys: [0, 2, 6].map((at) => ({ at, ease: "even" })),
};
const moments = ({ keys }: SpaceTimeline) => keys.map(({ at }) => at);

describe("a moment", () => {
  it("is within the time line, and may be its very end, however it goes on", () => {
    for (const loop of ["once", "round", "pingpong"] as const) {
      const now: SpaceTimeline = { ...line, loop };
      expect([-1, 0.12345, 6, 9, Number.NaN].map((at) => momentIn(now, at))).toEqual([0, 0.123, 6, 6, 0]);
    }
  });

  it("finds the key that is there, and the next ones", () => {
    expect([0, 0.01, 0.5, 2.01, 6].map((at) => keyAt(line, at))).toEqual([0, 0, -1, 1, 2]);
    expect(nextKey(line, 0, 1)).toBe(2);
    expect(nextKey(line, 2, -1)).toBe(0);
    expect(nextKey(line, 6, 1)).toBe(6);
    expect(nextKey({ ...line, loop: "round" }, 6, 1)).toBe(0);
    expect(nextKey({ ...line, loop: "round" }, 0, -1)).toBe(6);
    expect(nextKey({ ...line, loop: "pingpong" }, 6, 1)).toBe(6);
  });
});

describe("a key", () => {
  it("is moved between its neighbours, and never onto one", () => {
    expect(moments(withKeyAt(line, 1, 3.12345))).toEqual([0, 3.123, 6]);
    const [, far = 0] = moments(withKeyAt(line, 1, 99));
    expect(far).toBeLessThan(6);
    expect(keyAt({ keys: line.keys.filter((_, i) => i !== 1) }, far)).toBe(-1);
    const [, near = 0] = moments(withKeyAt(line, 1, -5));
    expect(near).toBeGreaterThan(0);
    for (const loop of ["once", "round", "pingpong"] as const)
      expect(moments(withKeyAt({ ...line, loop }, 2, 99))).toEqual([0, 2, 6]);
    expect(withKeyAt(line, 1, 2)).toBe(line);
    expect(withKeyAt(line, 1, Number.NaN)).toBe(line);
    expect(withKeyAt(line, 7, 1)).toBe(line);
  });

  it("goes, and changes its pace", () => {
    expect(moments(withoutKey(line, 1))).toEqual([0, 6]);
    expect(withoutKey(line, 3)).toBe(line);
    expect(withEase(line, 1, "hold").keys.map(({ ease }) => ease)).toEqual(["even", "hold", "even"]);
    expect(withEase(line, 1, "even")).toBe(line);
  });
});

describe("the length", () => {
  it("keeps the keys, and says which one is in the way", () => {
    expect(withSeconds(line, 9)).toEqual({ ...line, seconds: 9 });
    expect(withSeconds(line, 5)).toBe(line);
    expect(secondsProblem(line, 5)).toContain("Keyframe 3 is at 6 s");
    expect(secondsProblem(line, 6)).toBeUndefined();
    expect(secondsProblem({ ...line, loop: "round" }, 6)).toBeUndefined();
  });

  it("and the keys stay, whatever comes after the end", () => {
    for (const loop of ["round", "pingpong"] as const) {
      expect(withLoop(line, loop)).toEqual({ ...line, loop });
      expect(withLoop(withLoop(line, loop), "once")).toEqual(line);
    }
    expect(withLoop(line, "once")).toBe(line);
    const jumps = (["once", "round", "pingpong"] as const).map((loop) => jumpsBack({ ...line, loop }));
    expect(jumps).toEqual([false, true, false]);
    expect(jumpsBack({ ...line, loop: "round", seconds: 7 })).toBe(false);
  });

  it("takes the keys along where all of it is slower or faster", () => {
    const slow = stretched(line, 2);
    expect([slow.seconds, moments(slow)]).toEqual([12, [0, 4, 12]]);
    expect(moments(stretched(slow, 0.5))).toEqual(moments(line));
    expect(stretched(line, 1000)).toBe(line);
    expect(stretched(line, 0.001)).toBe(line);
    expect(stretched(line, 0)).toBe(line);
  });
});
