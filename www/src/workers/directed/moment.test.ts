import { expect, test, vi } from "vitest";
import type { DirectedIfs } from "#wasm/api";
import { drawnAt, systemAt } from "./moment";

const system = (x: number): DirectedIfs => ({ states: [[{ from: 0, map: [0.5, 0, 0, 0.5, x, 0] }]] });
const [from, to, split] = [system(0), system(1), system(2)];
const way = { from, to, mode: "linear" as const };
const interpolateDirected = vi.hoisted(() => vi.fn());
vi.mock("#wasm/directed", () => ({ directed: { interpolateDirected } }));

test("the ends are drawn in the parts of the way, whose colours stay, and known as they are", () => {
  interpolateDirected.mockReturnValue(split);
  for (const t of [0, 0.5, 1]) {
    expect(drawnAt({ ...way, t })).toBe(split);
    expect(interpolateDirected).toHaveBeenLastCalledWith(from, to, { u: t, v: t, mode: "linear" });
  }
  expect([systemAt({ ...way, t: 0 }), systemAt({ ...way, t: 1 })]).toEqual([from, to]);
});

test("shapes without a way between them are drawn at the ends all the same", () => {
  interpolateDirected.mockImplementation(() => {
    throw new Error("too many states");
  });
  expect([drawnAt({ ...way, t: 0 }), drawnAt({ ...way, t: 1 })]).toEqual([from, to]);
  expect(() => drawnAt({ ...way, t: 0.5 })).toThrow("too many states");
});
