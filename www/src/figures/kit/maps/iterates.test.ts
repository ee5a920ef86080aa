import { describe, expect, it } from "vitest";
import { gasket } from "./families";
import { copies, MOST_COPIES, mostSteps } from "./iterates";
import { apply } from "./pieces";

describe("copies", () => {
  it("begin with the figure itself", () => {
    expect(copies(gasket(0.5), 0)).toEqual([{ map: [1, 0, 0, 1, 0, 0], first: null }]);
  });

  it("are those of the figure before under each map, known by the last map", () => {
    const maps = gasket(0.5);
    const [before, after] = [copies(maps, 2), copies(maps, 3)];
    expect(after.length).toBe(27);
    for (const [i, { map, first }] of after.entries()) {
      const letter = Math.floor(i / 9);
      expect(first).toBe(letter);
      const [outer, inner] = [maps[letter], before[i % 9]];
      if (!outer || !inner) throw new Error("missing");
      const [x, y] = apply(outer, apply(inner.map, [0.3, 0.7]));
      expect(apply(map, [0.3, 0.7])[0]).toBeCloseTo(x, 12);
      expect(apply(map, [0.3, 0.7])[1]).toBeCloseTo(y, 12);
    }
  });

  it("never are more than can be drawn", () => {
    expect(mostSteps(3)).toBe(9);
    expect(copies(gasket(0.5), 1000).length).toBe(3 ** 9);
    expect(copies([[0.5, 0, 0, 0.5, 0, 0]], 1000).length).toBe(1);
    for (const maps of [2, 3, 4, 7, 64]) expect(maps ** mostSteps(maps)).toBeLessThanOrEqual(MOST_COPIES);
  });
});
