import { describe, expect, it } from "vitest";
import type { SpaceTimeline } from "../../../engine/api";
import {
  keyAt,
  lastMoment,
  momentIn,
  nextKey,
  secondsProblem,
  stretched,
  withEase,
  withKeyAt,
  withLoop,
  withoutKey,
  withSeconds,
} from "./changes";

const line: SpaceTimeline = {
  seconds: 6,
  loop: false,
  course: "smooth",
  keys: [0, 2, 6].map((at) => ({ at, ease: "even" })),
};
const moments = ({ keys }: SpaceTimeline) => keys.map(({ at }) => at);

describe("a moment", () => {
  it("is within the time line; the end of a loop is its beginning", () => {
    expect([-1, 0.12345, 6, 9, Number.NaN].map((at) => momentIn(line, at))).toEqual([0, 0.123, 6, 6, 0]);
    const loop = { seconds: 6, loop: true };
    expect(momentIn(loop, 6)).toBeLessThan(6);
    expect(momentIn(loop, 6)).toBe(lastMoment(loop));
  });

  it("finds the key that is there, and the next ones", () => {
    expect([0, 0.01, 0.5, 2.01, 6].map((at) => keyAt(line, at))).toEqual([0, 0, -1, 1, 2]);
    expect(nextKey(line, 0, 1)).toBe(2);
    expect(nextKey(line, 2, -1)).toBe(0);
    expect(nextKey(line, 6, 1)).toBe(6);
    expect(nextKey({ ...line, loop: true }, 6, 1)).toBe(0);
    expect(nextKey({ ...line, loop: true }, 0, -1)).toBe(6);
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
    expect(moments(withKeyAt(line, 2, 99))).toEqual([0, 2, 6]);
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
    expect(secondsProblem(line, 5)).toContain("Key 3 stands at 6 s");
    expect(secondsProblem(line, 6)).toBeUndefined();
    expect(secondsProblem({ ...line, loop: true }, 6)).toBeDefined();
  });

  it("grows where a loop needs time to come back", () => {
    expect(withLoop(line, true)).toEqual({ ...line, loop: true, seconds: 9 });
    expect(withLoop({ ...line, seconds: 8 }, true)).toEqual({ ...line, loop: true, seconds: 8 });
    expect(withLoop({ ...line, loop: true, seconds: 9 }, false)).toEqual({ ...line, seconds: 9 });
    expect(withLoop(line, false)).toBe(line);
    const full = {
      ...line,
      seconds: 600,
      keys: [
        { at: 0, ease: "even" as const },
        { at: 600, ease: "even" as const },
      ],
    };
    expect(withLoop(full, true)).toBe(full);
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
