import { describe, expect, it } from "vitest";
import type { DirectedIfs } from "#wasm/api";
import { doubled, extended, madeOf, replaced, shortened, without } from "./systems";

const part = (from: number, x = 0) =>
  ({ from, map: [0.5, 0, 0, 0.5, x, 0] as const }) as DirectedIfs["states"][0][0];
const two: DirectedIfs = { states: [[part(0), part(1, 1)], [part(1)]] };

describe("changes of a graph-directed system", () => {
  it("touch one map alone and leave what was there", () => {
    expect(replaced(two, 0, 1, part(0, 2))).toEqual({ states: [[part(0), part(0, 2)], [part(1)]] });
    expect(doubled(two, 0, 1).states[0]).toEqual([part(0), part(1, 1), part(1, 1)]);
    expect(without(two, 0, 0).states).toEqual([[part(1, 1)], [part(1)]]);
    expect(two.states[0]).toHaveLength(2);
  });

  it("leave no state without maps, and no copy of a state that is gone", () => {
    expect(without(two, 1, 0)).toEqual(two);
    expect(shortened(two)).toEqual({ states: [[part(0), part(0, 1)]] });
    expect(shortened(shortened(two)).states).toHaveLength(1);
    const three = extended(two);
    expect(three.states).toHaveLength(3);
    expect(three.states[2]?.every(({ from }) => from === 2)).toBe(true);
    expect(shortened(three)).toEqual(two);
  });

  it("are told by what each state is made of", () => {
    expect(madeOf(two.states[0] ?? [])).toBe("1 copy of state 1, 1 copy of state 2");
    expect(madeOf([part(2), part(0), part(2)])).toBe("1 copy of state 1, 2 copies of state 3");
  });
});
