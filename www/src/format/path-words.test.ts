import { describe, expect, it } from "vitest";
import { STATE } from "#geometry/states";
import {
  bestWords,
  certifiedWords,
  halfTurnWords,
  listWords,
  matchWords,
  meritWords,
  pathWords,
  roomWords,
} from "./path-words";

describe("pathWords", () => {
  const { connected, touching, disconnected, hidden, none, undecided } = STATE;
  /** Of 101 moments: a state up to each place. */
  const along = (...spans: [to: number, state: number][]) =>
    Array.from({ length: 101 }, (_, i) => spans.find(([to]) => i <= to)?.[1] ?? touching);

  it("says what is said of a shape: whole at the resolution, or proved", () => {
    expect(pathWords({ states: along(), widest: 0 })).toBe("No gap above 1/600 seen anywhere on the path.");
    expect(pathWords({ states: along([100, connected]), widest: 0 })).toBe(
      "In one piece, proved, at every sampled moment.",
    );
    // As the frames of the film say it, of which all may be proved: no state is told for another.
    expect(pathWords({ states: along([49, connected]), widest: 0 })).toBe(
      "In one piece, proved, at 49% of the sampled moments. At the others no gap above 1/600 was seen.",
    );
    expect(pathWords({ states: along([99, connected]), widest: 0, progress: 0.5 })).toBe(
      "In one piece, proved, at 99% of the sampled moments so far. At the others no gap above 1/600 was seen.",
    );
    expect(pathWords({ states: along([0, connected]), widest: 0 })).toContain("less than 1%");
    expect(pathWords({ states: along(), widest: 0, proved: true })).toBe(
      "In one piece, proved, along the whole path.",
    );
    expect(pathWords({ states: along(), widest: 0, progress: 0.5 })).toContain("so far");
    expect(pathWords({ states: [], widest: 0, progress: 0 })).toContain("Checking");
  });
  it("says where it is in pieces and how wide the gap is", () => {
    expect(pathWords({ states: along([61, touching], [80, disconnected]), widest: 0.03 })).toBe(
      "In pieces between 62% and 81%, widest gap 3%, by Frond’s own bounds.",
    );
  });
  it("says so too where no pixel shows it", () => {
    const words = pathWords({ states: along([89, touching], [95, hidden]), widest: 0.0015 });
    expect(words).toBe(
      "In pieces between 90% and 96%, gap 0.15%, under 1/600 of its size, by Frond’s own bounds.",
    );
    // Read off the map, how wide it is is not known: it is not 0.
    expect(pathWords({ states: along([89, touching], [95, hidden]), widest: 0, progress: 0.9 })).toBe(
      "In pieces between 90% and 96% so far, gap under 1/600 of its size, by Frond’s own bounds.",
    );
    // Beside gaps that are seen, not.
    const both = along([20, touching], [30, disconnected], [89, touching], [95, hidden]);
    expect(pathWords({ states: both, widest: 0.03 })).not.toContain("under");
  });
  it("tells pieces from no attractor and from what is not decided", () => {
    const states = along([20, touching], [30, none], [40, touching], [50, undecided]);
    expect(pathWords({ states, widest: 0 })).toBe(
      "No attractor between 21% and 31%. Not decided between 41% and 51%.",
    );
  });
  it("counts where there are many", () => {
    const states = Array.from({ length: 101 }, (_, i) => (i % 20 < 10 ? disconnected : touching));
    expect(pathWords({ states, widest: 0.2 })).toBe(
      "In pieces between 0% and 10%, between 20% and 30% and in 4 more places, widest gap 20%, by Frond’s own bounds.",
    );
  });
});

describe("listWords", () => {
  it("joins with commas and an and", () => {
    expect(listWords([])).toBe("");
    expect(listWords(["A"])).toBe("A");
    expect(listWords(["A", "B", "C"])).toBe("A, B and C");
  });
});

describe("what is proved of a path", () => {
  const so = { done: 48, parts: 48, gap: 0.0031, boxes: 4212, worst: 0.634, problem: null };

  it("gives the bound, the steps and the place where it is weakest", () => {
    expect(certifiedWords(so)).toBe(
      "Proved in 4,212 steps: no moment of this path has a gap wider than 0.31% of the shape’s diameter. Between the sampled moments narrower gaps are still possible; the widest would be near 63%.",
    );
    expect(certifiedWords({ ...so, gap: 0 })).toBe(
      "In one piece, proved for every moment of this path, in 4,212 steps.",
    );
  });

  it("names joints where they hold all of it, and what rounding leaves", () => {
    const words = certifiedWords({ ...so, gap: 2e-15, boxes: 0, joints: 3 });
    expect(words).toContain("3 joints");
    expect(words).toContain("up to rounding (2e-15 of the shape’s diameter)");
    expect(certifiedWords({ ...so, joints: 0 })).toContain("4,212 steps");
  });

  it("claims nothing before the end, nor without a bound", () => {
    expect(certifiedWords({ ...so, done: 12 })).toBe("Proving: 25% of the path so far.");
    expect(certifiedWords({ ...so, gap: Number.POSITIVE_INFINITY })).toMatch(
      /^The whole path could not be proved/,
    );
    expect(certifiedWords({ ...so, problem: "The path is too long." })).toBe(
      "The path could not be proved. The path is too long.",
    );
  });
});

describe("room and best", () => {
  it("tells how near a path comes to breaking", () => {
    expect(roomWords(0.0834)).toBe("It keeps a distance of 0.08 from where the shape breaks.");
    expect(roomWords(0.001)).toBe("It runs right along the border.");
    expect(roomWords(Number.POSITIVE_INFINITY)).toBe("");
    expect(roomWords(undefined)).toBe("");
  });

  it("says how sure it is that no path holds", () => {
    expect(bestWords(false, false)).toBe(
      "Frond found no path here that stays in one piece; this one opens the smallest gap.",
    );
    expect(bestWords(true, true)).toMatch(/every path breaks somewhere, even with the third parameter;/);
  });
});

describe("ways to match", () => {
  it("are told in words while they are few", () => {
    expect(matchWords([0, 1, 2], [0, 0, 0])).toBe("each keeps its number");
    expect(matchWords([1, 0, 2], [])).toBe("1 becomes 2 and 2 becomes 1");
    expect(matchWords([1, 2, 3, 4, 0], [0, 1, 0, 0, 0])).toBe(
      "5 of 5 maps change partner; one turns differently",
    );
  });

  it("say which maps could turn the other way round", () => {
    expect(halfTurnWords([0, 0])).toBeNull();
    expect(halfTurnWords([0, 1, 0])).toBe(
      "Map 2 makes exactly half a turn, clockwise. Half a turn counter-clockwise is just as short.",
    );
    expect(halfTurnWords([-1, 0, 1, 1])).toBe(
      "Maps 1, 3 and 4 make exactly half a turn, which is equally short in either direction.",
    );
  });

  it("are told by the best path that they allow", () => {
    expect(meritWords({ holds: true, gap: 0 })).toBe("no gap seen anywhere");
    expect(meritWords({ holds: false, gap: 0.012 })).toBe("gap 1.2%");
    expect(meritWords({ holds: false, gap: Number.POSITIVE_INFINITY })).toBe(
      "no attractor somewhere on the path",
    );
  });
});
