import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import { directionWords, narrowed, nearestOther, probes, sideOf, uniform } from "./boundary";

const field = (rows: readonly string[]) => {
  const codes = {
    c: STATE.connected,
    t: STATE.touching,
    d: STATE.disconnected,
    h: STATE.hidden,
    ".": STATE.pending,
  };
  const state = Uint8Array.from(
    // The first row of the picture is on top.
    [...rows].reverse().join(""),
    (one) => codes[one as keyof typeof codes],
  );
  const width = rows[0]?.length ?? 0;
  const bounds = { u0: 0, v0: 0, u1: width - 1, v1: rows.length - 1 };
  return { width, height: rows.length, state, gap: new Float32Array(state.length), bounds };
};

describe("a view of one colour", () => {
  it("is on one side, and proved only where all of it is", () => {
    expect(uniform(field(["cc", "cc"]))).toEqual({ side: "holds", proved: true });
    expect(uniform(field(["ct", "cc"]))).toEqual({ side: "holds", proved: false });
    expect(uniform(field(["dd", "hd"]))).toEqual({ side: "broken", proved: true });
    expect(uniform(field(["cd", "cc"]))).toBeNull();
    // What is not known yet is no colour.
    expect(uniform(field(["c.", "cc"]))).toBeNull();
  });

  it("has the nearest sample of the other side, whichever way it lies", () => {
    const map = field(["ccccd", "ccccc", "ccccc", "dcccc"]);
    expect(nearestOther(map, [3.4, 2.8], "holds")).toEqual([4, 3]);
    expect(nearestOther(map, [0.9, 0.2], "holds")).toEqual([0, 0]);
    expect(nearestOther(map, [0, 0], "broken")).toEqual([1, 0]);
    expect(nearestOther(field(["cc", "c."]), [0, 0], "holds")).toBeNull();
  });

  it("says the way in words", () => {
    expect(directionWords([0, 0], [1, 0.1])).toBe("to the right");
    expect(directionWords([0, 0], [-1, 1])).toBe("up and to the left");
    expect(directionWords([0, 0], [0.1, -1])).toBe("down");
    expect(directionWords([0, 0], [-1, -0.01])).toBe("to the left");
  });
});

describe("the boundary between two points", () => {
  it("is closed in on, round by round", () => {
    const edge = 0.371859123456;
    let [from, to]: [Uv, Uv] = [
      [0, 0],
      [1, 0.5],
    ];
    for (let round = 0; round < 9; round++) {
      const states = probes(from, to).map(([u]) => (u < edge ? STATE.touching : STATE.disconnected));
      [from, to] = narrowed(from, to, states, "holds");
      expect(from[0]).toBeLessThanOrEqual(edge);
      expect(to[0]).toBeGreaterThanOrEqual(edge);
    }
    expect(to[0] - from[0]).toBeLessThan(1e-10);
  });

  it("is the nearest of several, and none is made up where nothing was decided", () => {
    const states = Array.from({ length: 15 }, (_, k) =>
      k === 4 || k > 9 ? STATE.disconnected : STATE.connected,
    );
    const [from, to] = narrowed([0, 0], [16, 0], states, "holds");
    expect([from[0], to[0]]).toEqual([4, 5]);
    const open = Array.from({ length: 15 }, () => STATE.undecided);
    expect(narrowed([0, 0], [16, 0], open, "holds")).toEqual([
      [0, 0],
      [16, 0],
    ]);
    expect(sideOf(STATE.undecided)).toBe("unknown");
  });
});
