import { describe, expect, it } from "vitest";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import {
  BoundarySearch,
  directionWords,
  narrowed,
  othersOf,
  probes,
  sideOf,
  sideWords,
  uniform,
} from "./boundary";

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
    expect(uniform(field(["cc", "cc"]))).toEqual({ side: "holds", proved: 1 });
    expect(uniform(field(["ct", "cc"]))).toEqual({ side: "holds", proved: 0.75 });
    expect(uniform(field(["dd", "hd"]))).toEqual({ side: "broken", proved: 1 });
    expect(uniform(field(["cd", "cc"]))).toBeNull();
    // What is not known yet is no colour.
    expect(uniform(field(["c.", "cc"]))).toBeNull();
  });

  it("is told with what part of it is proved", () => {
    const words = (rows: string[]) =>
      sideWords(uniform(field(rows)) ?? { side: "unknown", proved: 0 }, 1 / 600);
    expect(words(["cc", "cc"])).toBe("All of this is in one piece, proved.");
    expect(words(["ct", "tc"])).toBe(
      "No gap above 1/600 seen anywhere here. For 50% of it, one piece is proved.",
    );
    expect(words(["tt", "tt"])).toBe("No gap above 1/600 seen anywhere here.");
    expect(words(["dd", "hd"])).toBe("All of this is in pieces, by Frond’s own bounds.");
  });

  it("has samples of the other side, the nearest first, up to one that is so however closely one looks", () => {
    const map = field(["ccccd", "ccccc", "ccccc", "dcccc"]);
    expect(othersOf(map, [3.4, 2.8], "holds")).toEqual([[4, 3]]);
    expect(othersOf(map, [0.9, 0.2], "holds")).toEqual([[0, 0]]);
    expect(othersOf(map, [0, 0], "broken")).toEqual([[1, 0]]);
    expect(othersOf(field(["cc", "c."]), [0, 0], "holds")).toEqual([]);
    expect(othersOf(field(["dtttcc"]), [0, 0], "broken")).toEqual([
      [1, 0],
      [2, 0],
      [3, 0],
      [4, 0],
    ]);
    // What is proved is never left out, however much else there is.
    expect(othersOf(field(["dtttcc"]), [0, 0], "broken", 1)).toEqual([
      [1, 0],
      [4, 0],
    ]);
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

describe("the search for the boundary", () => {
  const run = (others: Uv[], stateAt: (at: Uv) => number) => {
    const search = new BoundarySearch([0, 0], others, "broken", ([a], [b]) => Math.abs(a - b) < 1e-9);
    for (let places = search.next(); places.length > 0; places = search.next())
      search.take(places.map(stateAt));
    return search.found;
  };

  it("goes on to the next sample where one is in pieces as closely as one looks now", () => {
    const stateAt = ([u]: Uv) => (u < 0.7 ? STATE.disconnected : STATE.connected);
    const found = run(
      [
        [0.3, 0],
        [0.5, 0],
        [0.9, 0],
      ],
      stateAt,
    );
    expect(found?.[0][0]).toBeCloseTo(0.7, 8);
    expect(found?.[1][0]).toBeCloseTo(0.7, 8);
  });

  it("says that there is none instead of leading to a sample that is no other", () => {
    const many = Array.from({ length: 40 }, (_, k): Uv => [k + 1, 0]);
    expect(run(many, () => STATE.hidden)).toBeNull();
    expect(run(many, () => STATE.undecided)).toBeNull();
  });
});
